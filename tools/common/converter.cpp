// SPDX-License-Identifier: BSD-3-Clause
#include "common/converter.hpp"

#include <algorithm>

#include "base/path.hpp"
#include "common/input.hpp"
#include "common/shared_options.hpp"
#include "smurf/confine.hpp"

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

CheckSettings Conversion::settings() const {
  CheckSettings settings;
  for (const std::string_view name : report_format_names()) settings.formats.emplace_back(name);
  settings.packages = options_.packages;
  return settings;
}

std::optional<LoadedModel> Conversion::load_model(const std::string& path) {
  const auto name = open(path);
  if (!name) return std::nullopt;
  return session_.load_model(*name, settings());
}

std::optional<LoadedScene> Conversion::load_scene(const std::string& path) {
  auto name = open(path);
  if (name) name = find_main_file(tool_, *name, files());
  if (!name) return std::nullopt;
  return session_.load_scene(*name, settings());
}

std::optional<xml::Document> Conversion::load_xml(const std::string& path, Loaded& beside) {
  disk_.allow(path);
  if (const auto reason = why_unreadable(path, files_)) {
    complain(tool_, "cannot read '" + path + "': " + *reason);
    return std::nullopt;
  }
  LoadContext loading = session_.context_of(beside);
  auto document = smurf::load_xml(path, loading);
  if (!document) complain(tool_, "'" + path + "' is not well-formed XML");
  return document;
}

ExitCode Conversion::write_reports(Report report) {
  std::vector<Diagnostic>& diagnostics = report.diagnostics;
  if (options_.quiet) {
    std::erase_if(diagnostics, [](const Diagnostic& d) { return d.severity != Severity::error; });
  }
  // A clean run says nothing: the result is what was asked for.
  std::vector<ReportRequest> requests = options_.reports;
  if (requests.empty() && !diagnostics.empty()) {
    requests.push_back({find_report_format("full"), {}});
  }
  for (const ReportRequest& request : requests) {
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
  return report.summary.errors > 0 ? kFindings : judge(report.summary, options_.threshold);
}

bool Conversion::keeps_inputs(std::vector<std::string> outputs) const {
  for (const ReportRequest& report : options_.reports) outputs.push_back(report.file);
  return tools::keeps_inputs(tool_, inputs_, outputs);
}

bool Conversion::report_losses(const LoadedModel& loaded, std::vector<Diagnostic> losses,
                               const std::string& file, bool are_refused) {
  losses = session_.finish(loaded, std::move(losses));
  const SourceMap& sources = *loaded.sources;
  if (!file.empty() &&
      !write_output(tool_, file, render_losses_json(losses, sources, {tool_, kVersion}))) {
    return false;
  }
  if (!are_refused) return true;
  for (const Diagnostic& loss : losses) {
    write_error(render_concise(loss, sources, style_for(Stream::error, options_.color)));
  }
  return losses.empty();
}

ExitCode Conversion::refuse(std::string_view reason) const {
  complain(tool_, "'" + path_ + "' " + std::string(reason) + "; nothing was written");
  return kFindings;
}

}  // namespace smurf::tools
