// SPDX-License-Identifier: BSD-3-Clause
#include "check/pipeline.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "base/files/canonical_paths.hpp"
#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "check/xacro_places.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

template <class Linked>
Judged take(const Linked& linked, const SourceMap& sources, DiagnosticSink& sink,
            const xacro::Expansions& expansions) {
  Judged judged;
  judged.comments.add(linked, sources, expansions);
  judged.diagnostics = sink.take();
  locate(linked, judged.diagnostics);
  place_in_xacro(expansions, sources, judged.diagnostics);
  return judged;
}

/// The path of a file relative to a folder; for a file outside of it, the path starts with "..".
BaselinePath relative_to_folder_of(const std::string& file) {
  const std::string folder(path::parent(places::whole(file).value_or("")));
  return [folder](const std::string& path) {
    const auto whole = places::whole(path);
    const std::string relative = whole ? places::relative(*whole, folder) : std::string();
    return relative.empty() ? path : relative;
  };
}

/// The findings that remain under the settings of the group. Adds the number of findings that
/// comments suppress to `suppressed`, and the effects of all findings on the targets to the
/// verdicts.
std::vector<Diagnostic> settle(Judged&& judged, const CheckGroup& group, const SourceMap& sources,
                               std::size_t& suppressed, std::vector<TargetVerdict>& verdicts) {
  const RuleSelection& selection = group.selection;
  std::vector<Diagnostic> found =
      apply_selection(std::move(judged.diagnostics), sources, selection);
  for (TargetVerdict& verdict : verdicts) verdict.add(judge_target(*verdict.reader, found));
  if (!group.settings.heeds_comments) return found;
  const std::size_t before = found.size();
  const std::size_t count = judged.comments.apply(found, sources, selection);
  suppressed += count;
  // The findings about comments come last; only the selection is not applied to them yet.
  const auto about_comments = found.begin() + static_cast<std::ptrdiff_t>(before - count);
  std::vector<Diagnostic> added(std::make_move_iterator(about_comments),
                                std::make_move_iterator(found.end()));
  found.erase(about_comments, found.end());
  append(apply_selection(std::move(added), sources, selection), found);
  return found;
}

/// Removes the findings that the baseline records and returns their number. Adds the findings in
/// the baseline itself.
std::size_t apply_baseline(const std::string& path, const CheckGroup& group,
                           const CheckContext& context, SourceMap& sources,
                           std::vector<Diagnostic>& found) {
  DiagnosticSink sink;
  const FileContent content = context.files.read(path, context.limits.file_bytes);
  if (content.status != ReadStatus::ok) {
    const bool is_configured = group.settings.baseline.empty();
    const Span place =
        is_configured ? group.config.baseline->span : Span{sources.add_unreadable(path), 0, 0};
    sink.report(rules::sml9002_wrong_setting, place,
                "cannot read `" + path + "`: " + content.reason)
        .help("write it with `--generate-baseline`");
    append(apply_selection(sink.take(), sources, group.selection), found);
    return 0;
  }
  Baseline baseline(relative_to_folder_of(path));
  const SourceId source = sources.add(path, content.text);
  if (const auto document = parse_yaml(sources, source, context.limits, sink)) {
    baseline.read(*document, sink);
  }
  const std::size_t count = baseline.apply(found, sources);
  baseline.report_stale(sources, group.selection, sink);
  append(apply_selection(sink.take(), sources, group.selection), found);
  return count;
}

/// Findings that decide a verdict and are not in `left` were suppressed.
void note_passed(const std::vector<Diagnostic>& left, std::size_t TargetVerdict::*counter,
                 std::vector<TargetVerdict>& verdicts) {
  for (TargetVerdict& verdict : verdicts) {
    const Answer answer = verdict.answer();
    const std::size_t before = verdict.count(answer) - verdict.ignored - verdict.in_baseline;
    const std::size_t after = judge_target(*verdict.reader, left).count(answer);
    if (after < before) verdict.*counter += before - after;
  }
}

/// Reports when not every file was compared with every pattern of `paths`.
void report_path_checks(const CheckGroups& groups, const CheckContext& context,
                        const SourceMap& sources, std::vector<Diagnostic>& found) {
  const auto group = std::find_if(groups.begin(), groups.end(),
                                  [](const CheckGroup& one) { return !one.config.paths.empty(); });
  if (group == groups.end() || !group->path_checks->is_exhausted) return;
  DiagnosticSink sink;
  sink.report(rules::sml0002_file_too_large, group->config.paths.front().pattern.text.span,
              "there are more than " + std::to_string(context.limits.path_checks) +
                  " comparisons of files with patterns of `paths`; the remaining files are "
                  "checked without these settings")
      .help(raise_limit("path-checks"));
  append(apply_selection(sink.take(), sources, group->selection), found);
}

/// A file that two models share is one file.
std::size_t count_files(const SourceMap& sources, const CheckContext& context) {
  std::set<std::string> files;
  for (std::size_t i = context.first_source; i < sources.size(); ++i) {
    const SourceId source{static_cast<std::uint32_t>(i)};
    if (sources.is_readable(source))
      files.insert(identity(sources.path(source), context.paths, context.files));
  }
  return files.size();
}

/// Reports findings in the files that are meant for a variant of a robot.
void lint_variant(const Variant& variant, const RuleSelection& selection, DiagnosticSink& sink) {
  std::set<SourceId> of_files;
  for (const Companion& one : variant.companions.files) {
    of_files.insert(one.srdf ? one.srdf->document.source : one.source);
  }
  DiagnosticSink inner;
  lint_companions(variant.model, variant.companions, selection, inner);
  for (Diagnostic& one : inner.take()) {
    if (!of_files.contains(one.span.source)) continue;
    one.note("compared with `" + variant.model.path + "` with " + variant.arguments);
    Diagnostic& found = sink.report(*one.rule, one.span, one.message);
    found = std::move(one);
  }
}

}  // namespace

Judged judge(const LinkedModel& model, const SourceMap& sources, const RuleSelection& selection,
             DiagnosticSink& sink, const xacro::Expansions& expansions) {
  lint_model(model, selection, sink);
  lint_companions(model, {}, selection, sink);
  return take(model, sources, sink, expansions);
}

Judged judge(const Accompanied& robot, const SourceMap& sources, const RuleSelection& selection,
             DiagnosticSink& sink, const xacro::Expansions& expansions) {
  lint_model(robot.model, selection, sink);
  lint_companions(robot.model, robot.companions, selection, sink);
  for (const Variant& one : robot.variants) lint_variant(one, selection, sink);
  Judged judged = take(robot.model, sources, sink, expansions);
  judged.comments.add(robot.companions, sources);
  locate(robot.companions, judged.diagnostics);
  for (const Variant& one : robot.variants) {
    judged.comments.add(one.companions, sources);
    locate(one.companions, judged.diagnostics);
  }
  // An SRDF that is not well-formed is not among the companions.
  for (Diagnostic& one : judged.diagnostics) {
    if (is_companion_path(sources.path(one.span.source))) one.when(cases::kInCompanion);
  }
  return judged;
}

Judged judge(const LinkedScene& scene, const SourceMap& sources, const RuleSelection& selection,
             DiagnosticSink& sink, const xacro::Expansions& expansions) {
  lint_scene(scene, selection, sink);
  for (const LinkedModel& model : scene.models) {
    lint_model(model, selection, sink);
    lint_companions(model, {}, selection, sink);
  }
  return take(scene, sources, sink, expansions);
}

std::vector<Diagnostic> placed(const LinkedScene& scene, std::vector<Diagnostic> found) {
  locate(scene, found);
  return found;
}

std::vector<Diagnostic> settle_others(const LinkedModel& model, std::vector<Diagnostic> found,
                                      const SourceMap& sources, const RuleSelection& selection,
                                      const xacro::Expansions& expansions) {
  locate(model, found);
  place_in_xacro(expansions, sources, found);
  return apply_selection(std::move(found), sources, selection);
}

std::vector<Diagnostic> settle_others(const LinkedScene& scene, std::vector<Diagnostic> found,
                                      const SourceMap& sources, const RuleSelection& selection,
                                      const xacro::Expansions& expansions) {
  locate(scene, found);
  place_in_xacro(expansions, sources, found);
  return apply_selection(std::move(found), sources, selection);
}

Report make_report(std::vector<Judged>&& found, const CheckGroups& groups,
                   const CheckContext& context, SourceMap& sources) {
  Report report;
  const CheckGroup& first = groups.front();
  std::vector<Diagnostic>& all = report.diagnostics;
  std::size_t suppressed = 0;
  for (const Reader* target : targets_of(groups)) report.targets.push_back({.reader = target});
  *first.path_checks = {context.limits.path_checks, false};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const CheckGroup& group = groups[i];
    Judged& judged = found[i];
    judged.diagnostics.insert(judged.diagnostics.begin(), group.found.begin(), group.found.end());
    append(settle(std::move(judged), group, sources, suppressed, report.targets), all);
  }
  report_path_checks(groups, context, sources, all);
  sort_findings(all, sources);
  if (suppressed > 0) note_passed(all, &TargetVerdict::ignored, report.targets);
  report.settings = report_settings_of(first);
  const std::string& baseline = report.settings.baseline;
  if (first.settings.heeds_baseline && !baseline.empty()) {
    suppressed += apply_baseline(baseline, first, context, sources, all);
    sort_findings(all, sources);
    note_passed(all, &TargetVerdict::in_baseline, report.targets);
  }
  report.summary = summarize(all);
  report.summary.suppressed = suppressed;
  report.summary.files = count_files(sources, context);
  return report;
}

bool is_baseline(std::string_view text) { return Baseline::is_written(text); }

std::string write_baseline(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources,
                           const std::string& path) {
  return Baseline(relative_to_folder_of(path)).write(diagnostics, sources);
}

}  // namespace smurf
