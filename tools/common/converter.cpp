// SPDX-License-Identifier: BSD-3-Clause
#include "common/converter.hpp"

#include <algorithm>

#include "base/path.hpp"
#include "common/confine.hpp"
#include "common/input.hpp"
#include "common/shared_options.hpp"

namespace smurf::tools {

std::vector<Option> converter_options(ConverterOptions& options, std::string_view output_help) {
  return {output_option(options.output, output_help),
          report_option("report", options.reports),
          fail_on_option(options.threshold),
          stdin_filename_option(options.stdin_filename),
          package_option(options.packages),
          allow_outside_option(options.allow_outside),
          limit_option(options.limits),
          color_option(options.color),
          quiet_option(options.quiet, "Say nothing but errors.")};
}

Setter take_one_operand(std::string& operand) {
  return [&operand](std::string_view value) -> std::optional<std::string> {
    if (!operand.empty()) return "'" + std::string(value) + "' is one operand too many";
    operand = value;
    return std::nullopt;
  };
}

Conversion::Conversion(std::string_view tool, const ConverterOptions& options)
    : tool_(tool), options_(options) {}

std::optional<std::string> Conversion::open(const std::string& path) {
  if (path.empty()) {
    complain(tool_, "no input is named; see --help");
    return std::nullopt;
  }
  path_ = path;
  const std::string named = path == "-" ? options_.stdin_filename : path;
  confine(disk_, std::span(&named, 1), options_.packages, options_.allow_outside);
  if (path == "-") {
    return read_standard_input(tool_, options_.stdin_filename, options_.limits, files_);
  }
  if (const auto reason = why_unreadable(path, files_)) {
    complain(tool_, "cannot read '" + path + "': " + *reason);
    return std::nullopt;
  }
  return path;
}

std::optional<LinkedModel> Conversion::load_model(const std::string& path) {
  const auto name = open(path);
  if (!name) return std::nullopt;
  LoadContext loading = context();
  return smurf::load_model(*name, loading);
}

std::optional<xml::Document> Conversion::load_xml(const std::string& path) {
  disk_.allow(path);
  if (const auto reason = why_unreadable(path, files_)) {
    complain(tool_, "cannot read '" + path + "': " + *reason);
    return std::nullopt;
  }
  LoadContext loading = context();
  auto document = smurf::load_xml(path, loading);
  if (!document) complain(tool_, "'" + path + "' is not well-formed XML");
  return document;
}

std::optional<LinkedScene> Conversion::load_scene(const std::string& path) {
  auto name = open(path);
  if (!name) return std::nullopt;
  if (is_archive(*name)) {
    ArchivedMain main = main_file_of_archive(*name, files_);
    if (main.path.empty()) {
      complain(tool_, "cannot read '" + path + "': it " + main.reason);
      return std::nullopt;
    }
    name = std::move(main.path);
  }
  LoadContext loading = context();
  return smurf::load_scene(*name, loading);
}

OldScenes Conversion::load_old_scenes(const LinkedScene& scene) {
  LoadContext loading = context();
  return smurf::load_old_scenes(scene, loading);
}

ExitCode Conversion::report(const LinkedModel& model) {
  lint_model(model, {}, sink_);
  std::vector<Diagnostic> diagnostics = sink_.take();
  locate(model, diagnostics);
  return write_reports(std::move(diagnostics), 1, 0);
}

ExitCode Conversion::report(const LinkedScene& scene) {
  lint_scene(scene, {}, sink_);
  for (const LinkedModel& model : scene.models) lint_model(model, {}, sink_);
  std::vector<Diagnostic> diagnostics = sink_.take();
  locate(scene, diagnostics);
  return write_reports(std::move(diagnostics), scene.models.size(), scene.scenes.size());
}

ExitCode Conversion::write_reports(std::vector<Diagnostic> diagnostics, std::size_t models,
                                   std::size_t scenes) {
  diagnostics = finish(std::move(diagnostics), sources_, {});
  Summary summary = summarize(diagnostics);
  summary.files = sources_.size();
  summary.models = models;
  summary.scenes = scenes;
  if (options_.quiet) {
    std::erase_if(diagnostics, [](const Diagnostic& d) { return d.severity != Severity::error; });
  }
  // A clean run says nothing: the result is what was asked for.
  std::vector<ReportRequest> reports = options_.reports;
  if (reports.empty() && !diagnostics.empty()) {
    reports.push_back({find_report_format("full"), {}});
  }
  for (const ReportRequest& report : reports) {
    const Results results{.diagnostics = diagnostics,
                          .sources = sources_,
                          .summary = summary,
                          .tool = tool_,
                          .quiet = options_.quiet};
    if (report.file.empty()) {
      write_error(report.format->render(results, style_for(Stream::error, options_.color)));
    } else if (!write_output(tool_, report.file, report.format->render(results, {}))) {
      return kFailed;
    }
  }
  return summary.errors > 0 ? kFindings : judge(summary, options_.threshold);
}

bool Conversion::keeps_inputs(std::vector<std::string> outputs) const {
  for (const ReportRequest& report : options_.reports) outputs.push_back(report.file);
  return tools::keeps_inputs(tool_, inputs_, outputs);
}

bool Conversion::report_losses(const LinkedModel& model, std::vector<Diagnostic> losses,
                               const std::string& file, bool are_refused) {
  locate(model, losses);
  losses = finish(std::move(losses), sources_, {});
  if (!file.empty() &&
      !write_output(tool_, file, render_losses_json(losses, sources_, {tool_, kVersion}))) {
    return false;
  }
  if (!are_refused) return true;
  for (const Diagnostic& loss : losses) {
    write_error(render_concise(loss, sources_, style_for(Stream::error, options_.color)));
  }
  return losses.empty();
}

ExitCode Conversion::refuse(std::string_view reason) const {
  complain(tool_, "'" + path_ + "' " + std::string(reason) + "; nothing was written");
  return kFindings;
}

}  // namespace smurf::tools
