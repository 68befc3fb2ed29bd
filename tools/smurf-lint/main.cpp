// SPDX-License-Identifier: BSD-3-Clause
// smurf-lint: checks SMURF models and scenes.
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/counted.hpp"
#include "common/cli/browser.hpp"
#include "common/cli/process.hpp"
#include "common/cli/progress.hpp"
#include "common/files/input.hpp"
#include "lint/suppress.hpp"
#include "render/printable.hpp"
#include "smurf-lint/dump.hpp"
#include "smurf-lint/explain.hpp"
#include "smurf-lint/findings_picture.hpp"
#include "smurf-lint/fix.hpp"
#include "smurf-lint/fix_inertia.hpp"
#include "smurf-lint/init.hpp"
#include "smurf-lint/options.hpp"
#include "smurf-lint/records.hpp"
#include "smurf-lint/rename_all.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf-lint/show_collisions.hpp"
#include "smurf-lint/show_config.hpp"
#include "smurf-lint/show_masses.hpp"
#include "smurf-lint/show_orders.hpp"
#include "smurf-lint/watch.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/check.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

/// The baseline of --generate-baseline when neither the command line nor --config names one.
constexpr std::string_view kBaselineName = ".smurf-lint-baseline.yaml";

/// Quotes a word of a command that a user may copy.
std::string shell_word(std::string_view text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

TextStyle style_of(const LintOptions& options, const std::string& file) {
  if (file.empty() || file == "-") return style_for(Stream::output, options.color);
  return {options.color == ColorChoice::always, 0};
}

ExitCode write_text(const LintOptions& options, std::string_view text) {
  return write_output(kSmurfLint, options.output, text) ? kDone : kFailed;
}

ExitCode explain(const LintOptions& options) {
  const TextStyle style = style_of(options, options.output);
  const std::string text = explanation(options.explain, style);
  if (text.empty()) {
    complain(kSmurfLint, nothing_to_explain(options.explain));
    return kFailed;
  }
  return write_text(options, text);
}

ExitCode list_rules(const LintOptions& options) {
  if (options.list_rules == "json") return write_text(options, render_rule_list_json(all_rules()));
  return write_text(options, render_rule_list(all_rules(), style_of(options, options.output)));
}

/// Settings of a report for people: most infos are shown only on request.
OverviewOptions overview(const LintOptions& options, const Threshold& threshold) {
  const bool is_asked_for =
      options.shows_all || !options.selection.select.empty() || threshold.fail_on == Severity::info;
  const Severity least = is_asked_for ? Severity::info : Severity::warning;
  return {options.min_severity.value_or(least), options.shows_all};
}

/// The least severity that a report for people shows.
Severity shown(const LintOptions& options, const Report& report) {
  return overview(options, merge_run(report.settings, options).threshold).least;
}

/// A report, and the session whose sources it refers to.
struct Checked {
  const Report& report;
  Session& session;
};

/// Says what was found, and which files have the reports: a page in a file is opened by people.
void tell_written(std::span<const ReportRequest> reports, const std::string& place,
                  const Report& report) {
  std::string files;
  for (const ReportRequest& request : reports) {
    const std::string& file = request.file.empty() ? place : request.file;
    files += (files.empty() ? "wrote " : ", ") + file;
  }
  const std::string summary = render_summary(report.summary, {});
  complain(kSmurfLint, files + ": " + summary.substr(0, summary.find('\n')));
}

/// Opens the report in the browser: the file `page`, or a temporary file if there is none.
ExitCode open_report(const Results& results, std::string page) {
  if (page.empty() || page == "-") {
    const std::string text = find_report_format("html")->render(results, {});
    page = write_temporary_page(kSmurfLint, "findings", text);
  }
  return !page.empty() && show_page(kSmurfLint, page) ? kDone : kFailed;
}

/// `place` is the destination of reports without a file.
ExitCode write_reports(const LintOptions& options, const LintPlan& plan, const std::string& place,
                       const Checked& checked, std::string remarks) {
  const Report& report = checked.report;
  const RunSettings settings = merge_run(report.settings, options);
  // The failure was already reported; "no findings" would hide it.
  const bool has_robots = report.summary.models + report.summary.scenes > 0;
  const bool is_nothing = !has_robots && report.diagnostics.empty() && !report.problems.empty();
  const Results results{
      .diagnostics = report.diagnostics,
      .sources = checked.session.sources(),
      .summary = report.summary,
      .targets = report.targets,
      .tool = kSmurfLint,
      .robots = report.robots,
      .remarks = std::move(remarks),
      .quiet = options.quiet || is_nothing,
      .counts_only = options.statistics,
      .overview = options.min_severity
                      ? overview(options, settings.threshold)
                      : show_answers(overview(options, settings.threshold), report.diagnostics),
      .least_failure = least_failure(report.summary, settings.threshold),
      .picture = [&] {
        if (report.diagnostics.empty()) return std::string();
        return picture_of(options, plan, checked.session);
      }};
  std::vector<Diagnostic> repaired;  // for a page
  const auto for_page = [&] {
    if (repaired.empty()) {
      repaired = with_inertia_repairs(report.diagnostics, options, plan, checked.session);
    }
    Results page = results;
    page.diagnostics = repaired;
    return page;
  };
  ExitCode code = kDone;
  bool is_seen = false;
  bool has_page = false;
  std::string page;
  for (const ReportRequest& request : settings.reports) {
    const std::string& file = request.file.empty() ? place : request.file;
    const bool is_page = request.format->name == "html";
    const TextStyle style = style_of(options, file);
    const std::string text = request.format->render(is_page ? for_page() : results, style);
    if (!write_output(kSmurfLint, file, text)) code = kFailed;
    is_seen = is_seen || file.empty() || file == "-" || file.starts_with("/dev/");
    if (is_page) {
      has_page = true;
      page = file;
    }
  }
  if (options.opens && code == kDone) code = open_report(for_page(), page);
  if (has_page && !is_seen && !options.quiet && code == kDone) {
    tell_written(settings.reports, place, report);
  }
  return code;
}

/// Says where the files that standard input names were looked up, if one was not found there.
std::string remark_on_input(const LintOptions& options, const LintPlan& plan,
                            const Report& report) {
  if (plan.standard_input.empty() || !options.stdin_filename.empty()) return {};
  const auto is_missing = [](const Diagnostic& one) {
    return one.rule == &rules::sml1604_mesh_missing || one.rule == &rules::sml2001_missing_file ||
           one.rule == &rules::sml5006_missing_entity_file;
  };
  if (std::none_of(report.diagnostics.begin(), report.diagnostics.end(), is_missing)) return {};
  return "paths start at the current folder; --stdin-filename PATH sets another place\n";
}

/// Robots of a folder that need arguments are not expanded. This is no finding, but should not pass
/// for a check.
std::string remark_on_arguments(const LintPlan& plan, const Checked& checked) {
  std::set<std::string_view> robots;
  for (const Diagnostic& one : checked.report.diagnostics) {
    const bool is_open =
        one.rule == &rules::sml3313_xacro_unknown_argument && one.severity == Severity::info;
    if (is_open) robots.insert(checked.session.sources().path(one.span.source));
  }
  if (robots.empty()) return {};
  const bool is_new = std::all_of(plan.configs.begin(), plan.configs.end(),
                                  [](const std::string& path) { return path.empty(); });
  return counted(robots.size(), "robot") + (robots.size() == 1 ? " was" : " were") +
         " not checked, because arguments have no value; " +
         (is_new ? "`smurf-lint --init` writes a configuration with the values in launch files\n"
                 : "--min-severity info shows which, and where to give one\n");
}

ExitCode report(const LintOptions& options, const LintPlan& plan, const Checked& checked,
                const Fixed* fixed) {
  // Standard output is then used for the fixed text.
  const bool is_changing = options.fix || options.renames_names();
  const bool is_taken = is_changing && !plan.standard_input.empty() && options.output.empty();
  const std::string place = is_taken ? "/dev/stderr" : options.output;
  const ExitCode written = write_reports(
      options, plan, place, checked,
      remark_on_input(options, plan, checked.report) + remark_on_arguments(plan, checked) +
          fix_remarks(fixed, checked.report.diagnostics, shown(options, checked.report)));
  if (written != kDone) return written;
  return judge(checked.report.summary, merge_run(checked.report.settings, options).threshold);
}

/// `remarks` come first; programs that read the difference ignore them.
ExitCode show_diff(const LintOptions& options, const Changes& changes,
                   const std::vector<std::string>& remarks = {}) {
  std::string text;
  for (const std::string& line : remarks) text += "# " + line + "\n";
  if (write_text(options, text + unified_diff(changes)) != kDone) return kFailed;
  return changes.empty() || options.threshold.exit_zero ? kDone : kFindings;
}

/// Writes the files; standard input goes to standard output.
bool write_all(const LintOptions& options, const LintPlan& plan, const Session& session,
               const Changes& changes) {
  if (!write_changes(changes, plan, options)) return false;
  const std::string& input = plan.standard_input;
  return input.empty() ||
         write_output(kSmurfLint, "-", session.files().read(input, options.limits.file_bytes).text);
}

ExitCode give_out(const LintOptions& options, const LintPlan& plan, Session& session,
                  const Fixed& fixed) {
  if (options.diff) return show_diff(options, fixed.changes);
  if (!write_all(options, plan, session, fixed.changes)) return kFailed;
  if (options.fix_only) return kDone;
  return report(options, plan, {fixed.report, session}, &fixed);
}

ExitCode fix(const LintOptions& options, const LintPlan& plan, Session& session, Report found,
             const std::function<Report()>& check) {
  const Severity least = shown(options, found);
  const Fixed fixed = fix_all(options, plan, session, std::move(found), least, check);
  if (fixed.end == FixEnd::no_end) {
    complain(kSmurfLint,
             "the fixes undo each other; nothing was changed (this is a bug of smurf-lint)");
    return kFailed;
  }
  const ExitCode code = give_out(options, plan, session, fixed);
  if (fixed.end != FixEnd::limit || code == kFailed) return code;
  complain(kSmurfLint,
           "not all fixes were applied: the others need more than " +
               std::to_string(options.limits.rechecked_bytes) +
               " bytes to be checked; run smurf-lint again after these are written, or " +
               raise_limit("rechecked-bytes"));
  return kFailed;
}

/// Writes other inertias. `check` reports on the changed texts.
ExitCode fix_inertia(const LintOptions& options, const LintPlan& plan, Session& session,
                     const std::function<Report()>& check) {
  const std::optional<InertiaChanges> changes = fix_inertias(options, plan, session);
  if (!changes) return kFailed;
  if (!options.quiet) {
    for (const std::string& line : changes->refused) complain(kSmurfLint, line);
  }
  if (options.diff) {
    const ExitCode code = show_diff(options, changes->files, changes->done);
    const bool is_left = !changes->refused.empty() && !options.threshold.exit_zero;
    return code == kDone && is_left ? kFindings : code;
  }
  if (!options.quiet) {
    for (const std::string& line : changes->done) complain(kSmurfLint, line);
  }
  if (!write_all(options, plan, session, changes->files)) return kFailed;
  if (options.fix_only) return kDone;
  return report(options, plan, {check(), session}, nullptr);
}

/// `found` are the findings in the renamed files.
ExitCode rename(const LintOptions& options, const LintPlan& plan, Session& session,
                const Changes& changes, const Report& found) {
  if (options.diff) return show_diff(options, changes);
  if (!write_all(options, plan, session, changes)) return kFailed;
  if (!options.quiet) {
    std::string renames;
    const auto add = [&](const auto& one) {
      renames += (renames.empty() ? "'" : ", '") + one.from + "' to '" + one.to + "'";
    };
    for (const Rename& one : options.renames) add(one);
    for (const XacroRename& one : options.xacro_renames) add(one);
    complain(kSmurfLint, "wrote " + counted(changes.size(), "file") + ": renamed " + renames);
  }
  if (options.fix_only) return kDone;
  return report(options, plan, {found, session}, nullptr);
}

/// The path of the baseline to write. A configuration beside the files cannot choose it; if it
/// names another path, reports this and returns none.
std::optional<std::string> baseline_to_write(const LintOptions& options, const std::string& known) {
  const bool is_chosen = !options.baseline.empty() || (!options.config.empty() && !known.empty());
  if (is_chosen) return known;
  std::string usual(kBaselineName);
  if (known.empty() || identity(known) == identity(usual)) return usual;
  complain(kSmurfLint, "a configuration that was found beside the files cannot choose the file to "
                       "write; to write its baseline, add --baseline " +
                           shell_word(known));
  return std::nullopt;
}

/// Whether a file is a baseline, which is read before it is written again: the search for
/// companions looks at every YAML file.
bool is_old_baseline(const std::string& path, const LintOptions& options) {
  const FileContent old = DiskFiles().read(path, options.limits.file_bytes);
  return old.status == ReadStatus::ok && is_baseline(old.text);
}

/// Only a baseline may be overwritten.
bool may_be_overwritten(const std::string& path, const LintOptions& options) {
  const FileContent old = DiskFiles().read(path, options.limits.file_bytes);
  if (old.status == ReadStatus::not_found) return true;
  if (old.status == ReadStatus::ok && is_baseline(old.text)) return true;
  const std::string reason =
      old.status == ReadStatus::ok ? "smurf-lint did not write it as a baseline" : old.reason;
  complain(kSmurfLint, "cannot write '" + path + "': " + reason);
  return false;
}

/// Records what a report for people shows: usually no infos, which would make up most of the file.
ExitCode write_baseline(const LintOptions& options, const Session& session, Report report) {
  const Severity least = overview(options, merge_run(report.settings, options).threshold).least;
  const std::size_t hidden = std::erase_if(
      report.diagnostics, [&](const Diagnostic& one) { return one.severity < least; });
  const std::string& known = report.settings.baseline;
  const auto path = baseline_to_write(options, known);
  if (!path || !may_be_overwritten(*path, options)) return kFailed;
  const std::string text = session.baseline_of(report, *path);
  const bool is_usual = *path == kBaselineName;
  const bool is_written = is_usual ? write_files(kSmurfLint, {{".", *path, text}}, true)
                                   : write_output(kSmurfLint, *path, text);
  if (!is_written) return kFailed;
  if (options.quiet) return kDone;
  const auto count = static_cast<std::size_t>(
      std::count_if(report.diagnostics.begin(), report.diagnostics.end(), may_be_in_baseline));
  std::string done = "wrote " + counted(count, "finding") + " to " + render::escape(*path);
  if (hidden > 0) {
    done += ", without " + counted(hidden, "info") + " (--min-severity info records " +
            (hidden == 1 ? "it" : "them") + ")";
  }
  if (known.empty()) done += "; from now on, add --baseline " + *path;
  return write_text(options, done + "\n");
}

bool keeps_inputs(const LintOptions& options, const Report& found,
                  std::span<const InputFiles* const> inputs) {
  std::vector<std::string> outputs{options.output};
  if (options.generate_baseline) {
    if (!is_old_baseline(options.baseline, options)) outputs.push_back(options.baseline);
  } else {
    for (const ReportRequest& request : merge_run(found.settings, options).reports) {
      outputs.push_back(request.file);
    }
  }
  return std::all_of(inputs.begin(), inputs.end(), [&](const InputFiles* read) {
    return tools::keeps_inputs(kSmurfLint, *read, outputs);
  });
}

ExitCode list_files(const LintOptions& options, const LintPlan& plan, const InputFiles& inputs) {
  std::vector<std::string> paths;
  for (const auto* planned : {&plan.scenes, &plan.models, &plan.others}) {
    for (const PlannedFile& file : *planned) paths.push_back(file.path);
  }
  std::sort(paths.begin(), paths.end());
  std::string text;
  for (const std::string& path : paths) {
    text += render::escape(path) + "\n";
    inputs.add(path);
  }
  if (!tools::keeps_inputs(kSmurfLint, inputs, std::span(&options.output, 1))) return kFailed;
  const ExitCode code = write_text(options, text);
  return !plan.problems.empty() ? kFailed : code;
}

Report run_check(const LintOptions& options, const LintPlan& plan, Session& session) {
  CheckSettings settings = check_settings(options);
  std::optional<Progress> progress;
  settings.on_progress = [&](std::size_t done, std::size_t of) {
    if (done == 0) progress.emplace("checked", of, options.quiet);
    progress->set(done);
  };
  Report report = session.check(plan, settings);
  report.summary.links = plan.links;
  report.summary.is_strict = options.threshold.is_strict;
  // A configuration alone: there is nothing that a target could load.
  if (report.summary.models + report.summary.scenes + report.problems.size() == 0) {
    report.targets.clear();
  }
  if (options.min_severity) leave_out_below(*options.min_severity, report);
  return report;
}

/// Adds the paths that were asked for to `seen`, unless it is null.
ExitCode run(const LintOptions& options, std::set<std::string>* seen) {
  if (writes_records(options) && !options.list_files) return run_records(options);
  ConfinedFiles disk;
  confine_to_inputs(disk, options);
  const InputFiles inputs(disk);
  const ArchiveFiles archives(inputs, options.limits);
  MemoryFiles files(&archives);
  if (!can_read_named(options, files)) return kFailed;
  LintPlan plan = make_plan(options, files);
  if (options.list_files) return list_files(options, plan, inputs);
  ConfinedFiles confined;
  confine_to_found(confined, options, plan);
  const InputFiles read(confined);
  Session session(read, options.limits, stamp_on_disk);
  if (const std::string& name = plan.standard_input; !name.empty()) {
    session.set_text(name, files.read(name, options.limits.file_bytes).text);
  }
  std::optional<Changes> renamed;
  if (options.renames_names()) {
    if (plan.problems.empty()) renamed = rename_all(options, plan, session);
    if (!renamed) return kFailed;
  }
  const auto check = [&] { return run_check(options, plan, session); };
  if (options.fix_inertia) {
    return plan.problems.empty() ? fix_inertia(options, plan, session, check) : kFailed;
  }
  Report found = check();
  if (!keeps_inputs(options, found, std::array{&inputs, &read})) return kFailed;
  if (options.generate_baseline) {
    return !plan.problems.empty() ? kFailed : write_baseline(options, session, std::move(found));
  }
  if (renamed) return rename(options, plan, session, *renamed, found);
  if (seen != nullptr) *seen = read.asked();
  const ExitCode code = options.fix || options.fix_only || options.diff
                            ? fix(options, plan, session, std::move(found), check)
                            : report(options, plan, {found, session}, nullptr);
  return !plan.problems.empty() ? kFailed : code;
}

}  // namespace

int smurf_lint_main(int argc, char** argv) {
  prepare_process();
  LintOptions options;
  if (const auto code = parse_command_line(lint_command(options), argc, argv)) return *code;
  if (const auto conflict = find_conflict(options)) {
    complain(kSmurfLint, *conflict);
    return kFailed;
  }
  if (!options.explain.empty()) return explain(options);
  if (!options.list_rules.empty()) return list_rules(options);
  if (!options.show_config.empty()) return show_config(options);
  if (!options.masses.empty()) return show_masses(options);
  if (!options.collision_matrix.empty()) return show_collisions(options);
  if (!options.joint_orders.empty()) return show_joint_orders(options);
  if (!options.dump_model.empty()) return dump_model(options);
  if (options.init) return init(options);
  if (options.watch) {
    return watch(options, [&](std::set<std::string>& seen) { return run(options, &seen); });
  }
  return run(options, nullptr);
}
