// SPDX-License-Identifier: BSD-3-Clause
#include "common/convert/converter.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <string_view>
#include <utility>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/text/counted.hpp"
#include "common/cli/shared_options.hpp"
#include "common/files/input.hpp"
#include "render/printable.hpp"
#include "render/wrap.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/confine.hpp"
#include "smurf/found_inputs.hpp"
#include "smurf/result_losses.hpp"

namespace smurf::tools {

std::vector<Option> converter_options(ConverterOptions& options, std::string_view output_help) {
  Option fail_on = fail_on_option(options.threshold);
  fail_on.help =
      "Refuse to write when there is a finding of this severity or above: error, warning, info or "
      "never. By default, refuse only when a finding makes the result wrong.";
  return {output_option(options.output, output_help),
          report_option("report", options.reports),
          std::move(fail_on),
          stdin_filename_option(options.stdin_filename),
          package_option(options.packages),
          xacro_env_option(options.xacro.environment),
          allow_outside_option(options.allow_outside),
          limit_option(options.limits),
          max_seconds_option(options.max_seconds),
          color_option(options.color),
          quiet_option(options.quiet, "Print errors only.")};
}

Setter take_one_operand(std::string& operand) {
  return [&operand](std::string_view value) -> std::optional<std::string> {
    if (!operand.empty()) return "'" + std::string(value) + "' is one argument too many";
    operand = value;
    return std::nullopt;
  };
}

Setter take_one_operand(std::string& operand, XacroSettings& xacro) {
  return [one = take_one_operand(operand), &xacro](std::string_view value) {
    return take_xacro_argument(value, xacro) ? std::nullopt : one(value);
  };
}

Conversion::Conversion(std::string_view tool, const ConverterOptions& options,
                       std::vector<InputKind> kinds)
    : tool_(tool), options_(options), kinds_(std::move(kinds)) {}

bool Conversion::is_accepted(const std::string& path) const {
  const InputKind kind = input_kind(path);
  const auto takes = [&](InputKind one) {
    return std::find(kinds_.begin(), kinds_.end(), one) != kinds_.end();
  };
  const bool takes_models = takes(InputKind::model);
  std::string problem;
  switch (kind) {
  case InputKind::model:
  case InputKind::urdf: return true;
  case InputKind::scene:
  case InputKind::drawing:
    if (takes(InputKind::scene)) return true;
    problem = " is a scene; smurfs-flatten --format urdf exports it";
    break;
  case InputKind::annotation:
    problem =
        takes_models ? " is not a model; name the .smurf file that lists it" : " is not a URDF";
    break;
  case InputKind::resource:
    problem = takes_models ? " is not a model; name the .smurf or .urdf file that uses it"
                           : " is not a URDF";
    break;
  case InputKind::other: return true;
  }
  complain(tool_, "'" + path + "'" + problem);
  return false;
}

std::optional<std::string> Conversion::open(const std::string& path) {
  if (path.empty()) {
    complain(tool_, "no input file; see --help");
    return std::nullopt;
  }
  path_ = path;
  if (path != "-" && places::is_folder(path)) {
    const auto found = find_only_input(tool_, path, kinds_, options_.limits);
    if (!found) return std::nullopt;
    path_ = *found;
  }
  const std::string named = path == "-" ? options_.stdin_filename : path_;
  if (!is_accepted(named)) return std::nullopt;
  confine(disk_, std::span(&named, 1), options_.packages, options_.allow_outside);
  if (path == "-") {
    return read_standard_input(tool_, options_.stdin_filename, options_.limits, files_);
  }
  if (const auto reason = why_unreadable(path_, files_)) {
    complain(tool_, "cannot read '" + path_ + "': " + *reason);
    return std::nullopt;
  }
  return path_;
}

CheckSettings Conversion::settings() const {
  CheckSettings settings;
  for (const std::string_view name : report_format_names()) settings.formats.emplace_back(name);
  settings.packages = options_.packages;
  settings.xacro = options_.xacro;
  settings.max_seconds = options_.max_seconds;
  settings.selection.targets = options_.targets;
  return settings;
}

std::optional<LoadedModel> Conversion::load_model(const std::string& path) {
  const auto name = open(path);
  if (!name) return std::nullopt;
  return session_.load_model(*name, settings());
}

std::optional<LoadedExpansion> Conversion::load_xacro(const std::string& path) {
  const auto name = open(path);
  if (!name) return std::nullopt;
  CheckSettings wanted = settings();
  wanted.xacro.needs_origins = false;
  return session_.load_xacro(*name, wanted);
}

ExitCode Conversion::report(const LoadedExpansion& loaded, std::vector<Diagnostic> found) {
  Report report;
  report.diagnostics = std::move(found);
  report.summary = summarize(report.diagnostics);
  return this->report(std::move(report), [&](const Diagnostic& one) -> std::optional<std::string> {
    if (loaded.expansion.is_complete || one.severity != Severity::error) return std::nullopt;
    return "xacro stops";
  });
}

std::optional<LoadedScene> Conversion::load_scene(const std::string& path) {
  auto name = open(path);
  if (name) name = find_main_file(tool_, *name, files());
  if (!name) return std::nullopt;
  return session_.load_scene(*name, settings());
}

bool Conversion::allow(const std::string& path) {
  disk_.allow(path);
  const auto reason = why_unreadable(path, files_);
  if (reason) complain(tool_, "cannot read '" + path + "': " + *reason);
  return !reason;
}

std::optional<xml::Document> Conversion::load_srdf(const std::string& path, Loaded& beside) {
  if (!allow(path)) return std::nullopt;
  LoadContext loading = session_.context_of(beside);
  auto document = smurf::load_xml(path, loading);
  if (!document) {
    const std::deque<Diagnostic>& found = beside.found.diagnostics();
    const bool is_told = !found.empty() && beside.sources->path(found.back().span.source) == path;
    complain(tool_, "'" + path + "' is not well-formed XML" +
                        (is_told ? ": line " +
                                       std::to_string(beside.sources->line_of(
                                           found.back().span.source, found.back().span.begin)) +
                                       ": " + found.back().message
                                 : ""));
    return std::nullopt;
  }
  const std::string_view root = document->view().name();
  if (root == "robot") return document;
  complain(tool_, "'" + path + "' is no SRDF: its root element is '" + std::string(root) +
                      "', not 'robot'");
  return std::nullopt;
}

namespace {

constexpr std::size_t kMostLines = 34;  ///< of findings; what was written, and remarks, follow

bool is_of_converter(const Diagnostic& finding) {
  return finding.rule->reported_by == Tool::converters;
}

/// Whether a loss says which package the converter did not find. Formats that keep the addresses of
/// meshes lose nothing.
bool names_lost_package(std::span<const Diagnostic> findings) {
  return std::any_of(findings.begin(), findings.end(), [](const Diagnostic& finding) {
    return is_of_converter(finding) && is_about_lost_package(finding);
  });
}

/// Whether a finding comes from the converter, which smurf-lint does not report, or from a scene,
/// or is a package whose folder the user has to name.
bool is_told(const Diagnostic& finding, const SourceMap& sources, bool are_packages_named) {
  if (is_about_picture(finding)) return false;
  if (is_of_converter(finding)) return true;
  if (is_about_lost_package(finding)) return !are_packages_named;
  const InputKind kind = input_kind(sources.path(finding.span.source));
  return kind == InputKind::scene || kind == InputKind::drawing;
}

/// Whether smurf-lint does not know by the name what a file is: a .xml is MJCF for it.
bool is_unknown_to_lint(const FileReader& files, const std::string& path) {
  if (path::to_lower(path::extension(path)) == ".xml") {
    const FileContent content = files.read(path, Limits().file_bytes);
    return content.status == ReadStatus::ok && content.text.find("<mujoco") == std::string::npos;
  }
  return input_kind(path) == InputKind::other && path != "-" && !is_archive(path);
}

/// "9 errors and 5 warnings in what it is made of; see smurf-lint arm.smurf", or "".
std::string count_rest(std::span<const Diagnostic> rest, const std::string& path,
                       const FileReader& files) {
  const Summary summary = summarize(rest);
  std::string text;
  if (summary.errors > 0) text = counted(summary.errors, "error");
  if (summary.warnings > 0) {
    text += (text.empty() ? "" : " and ") + counted(summary.warnings, "warning");
  }
  if (text.empty()) return text;
  if (!is_unknown_to_lint(files, path)) return text + ": see smurf-lint " + path;
  // smurf-lint finds out by the name what a file is.
  const std::string stem = path.substr(0, path.size() - path::extension(path).size());
  return text + ": see smurf-lint --stdin-filename " + stem + ".urdf - < " + path;
}

/// "3 entries (2 in poses, 1 in sensors)", "3 entries in poses", or "" when there are none.
std::string by_section(const std::map<std::string_view, std::size_t>& counts,
                       std::string_view singular, std::string_view plural) {
  std::size_t all = 0;
  std::string text;
  for (const auto& [section, number] : counts) {
    text += (all == 0 ? " (" : ", ") + std::to_string(number) + " in " + std::string(section);
    all += number;
  }
  if (all == 0) return "";
  const std::string amount = counted(all, singular, plural);
  if (counts.size() == 1) return amount + " in " + std::string(counts.begin()->first);
  return amount + text + ")";
}

}  // namespace

/// "3 entries (2 in poses, 1 in sensors) and 4 values of other entries (4 in motors)". Findings in
/// a URDF have an XPath, which begins with the robot, and are not counted.
std::string count_by_section(std::span<const Diagnostic> losses) {
  std::map<std::string_view, std::size_t> entries;
  std::map<std::string_view, std::size_t> values;
  for (const Diagnostic& loss : losses) {
    const std::string_view section = section_of(loss);
    if (section == "robot") continue;
    // "/sensors/0" is an entry, "/maintenance" a section, and "/motors/0/p" a value of an entry.
    const bool is_value = std::count(loss.pointer.begin(), loss.pointer.end(), '/') > 2;
    ++(is_value ? values : entries)[section];
  }
  const std::string lost = by_section(entries, "entry", "entries");
  if (lost.empty()) return by_section(values, "value", "values");
  const std::string partly =
      by_section(values, "value of other entries", "values of other entries");
  return partly.empty() ? lost : lost + " and " + partly;
}

/// Shows findings that make the result wrong and findings of the converter, errors first; counts
/// the others.
std::string Conversion::render_for_people(const Report& report, const LossOf& loss_of,
                                          bool is_converted) {
  const SourceMap& sources = session_.loaded_sources();
  const TextStyle style = style_for(Stream::error, options_.color);
  const bool are_packages_named = names_lost_package(report.diagnostics);
  std::vector<Diagnostic> told, rest;
  for (const Diagnostic& finding : report.diagnostics) {
    const auto loss = loss_of(finding);
    if (loss || (!options_.quiet && is_told(finding, sources, are_packages_named))) {
      Diagnostic shown = finding;
      if (loss) {
        shown.notes.push_back(
            (is_converted ? "converted because of --force, although " : "not converted: ") + *loss);
      }
      told.push_back(std::move(shown));
    } else {
      rest.push_back(finding);
    }
  }
  const GroupedFindings grouped = render_grouped(told, sources, kMostLines, style);
  std::string text = grouped.text;
  if (!grouped.is_complete) {
    const std::string_view losses =
        options_.has_loss_report ? ", --loss-report FILE each loss" : "";
    text +=
        std::string(tool_) + ": --report concise shows each finding" + std::string(losses) + "\n";
  }
  const std::string line = options_.quiet ? "" : count_rest(rest, path_, files());
  if (!line.empty()) text += std::string(tool_) + ": " + render::escape(line) + "\n";
  return text;
}

ExitCode Conversion::report(Report report, const LossOf& loss_of, const Refusal& refusal) {
  why_ = why_not_converted(report.diagnostics, loss_of);
  ExitCode verdict = why_.empty() ? kDone : kFindings;
  if (verdict == kDone) verdict = judge(report.summary, options_.threshold);
  if (verdict != kDone && why_.empty()) why_ = "has findings that reach --fail-on";
  if (options_.reports.empty()) {
    write_error(render_for_people(report, loss_of, options_.force && !refusal));
  }
  std::vector<Diagnostic>& diagnostics = report.diagnostics;
  if (options_.quiet) {
    std::erase_if(diagnostics, [](const Diagnostic& d) { return d.severity != Severity::error; });
  }
  for (const ReportRequest& request : options_.reports) {
    const Results results{.diagnostics = diagnostics,
                          .sources = session_.loaded_sources(),
                          .summary = report.summary,
                          .tool = tool_,
                          .quiet = options_.quiet};
    if (request.file.empty()) {
      write_error(request.format->render(results, style_for(Stream::error, options_.color)));
    } else if (!write_output(tool_, request.file, request.format->render(results, {}))) {
      return kFailed;
    }
  }
  return verdict;
}

void Conversion::tell_written(const std::string& what, std::span<const std::string> remarks) const {
  const bool is_for_programs =
      std::any_of(options_.reports.begin(), options_.reports.end(),
                  [](const ReportRequest& report) { return report.file.empty(); });
  if (options_.quiet || is_for_programs) return;
  constexpr std::size_t kColumns = 80;
  complain(tool_, "wrote " + what);
  for (const std::string& remark : remarks) {
    write_error(render::wrap(render::escape(remark), 2, kColumns));
  }
}

bool Conversion::keeps_inputs(std::vector<std::string> outputs) const {
  for (const ReportRequest& report : options_.reports) outputs.push_back(report.file);
  return tools::keeps_inputs(tool_, inputs_, outputs);
}

bool Conversion::write_losses(std::span<const Diagnostic> losses, const std::string& file) const {
  return file.empty() ||
         write_output(tool_, file,
                      render_losses_json(losses, session_.loaded_sources(), {tool_, kVersion}));
}

Diagnostic Conversion::placed(const LoadedScene& loaded, const Diagnostic& found) const {
  std::vector<Diagnostic> finished = session_.settle(loaded, {found});
  return finished.empty() ? found : std::move(finished.front());
}

ExitCode Conversion::refuse(std::string_view reason) const {
  complain(tool_, "'" + path_ + "' " + std::string(reason) + "; nothing was written");
  return kFindings;
}

ExitCode Conversion::refuse(const Refusal& refusal) const {
  return refuse(refusal.reason + (refusal.can_be_forced ? "; see --force" : ""));
}

ExitCode Conversion::refuse_losses(std::span<const Diagnostic> losses) const {
  const TextStyle style = style_for(Stream::error, options_.color);
  for (const Diagnostic& loss : losses) {
    write_error(render_concise(loss, session_.loaded_sources(), style));
  }
  return refuse("has losses");
}

}  // namespace smurf::tools
