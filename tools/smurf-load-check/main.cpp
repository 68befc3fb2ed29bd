// SPDX-License-Identifier: BSD-3-Clause
// smurf-load-check: checks that models and scenes stand, hang and drop in ODE.
#include <algorithm>
#include <iterator>

#include "base/text/suggest.hpp"
#include "common/cli/process.hpp"
#include "common/cli/progress.hpp"
#include "smurf-load-check/check_report.hpp"
#include "smurf-load-check/options.hpp"
#include "smurf-load-check/trace.hpp"
#include "smurf-load-check/world.hpp"
#include "smurf/lint.hpp"

using namespace smurf;
using namespace smurf::load_check;
using namespace smurf::tools;

namespace {

constexpr std::string_view kTool = "smurf-load-check";

Summary summary_of(const Inputs& inputs, std::span<const Diagnostic> diagnostics) {
  Summary summary = summarize(diagnostics);
  for (std::size_t i = 0; i < inputs.sources.size(); ++i) {
    if (inputs.sources.is_readable(SourceId{static_cast<std::uint32_t>(i)})) ++summary.files;
  }
  for (const Job& job : inputs.jobs) ++(job.model != nullptr ? summary.models : summary.scenes);
  return summary;
}

/// If a model does not have the pose that the user requests, reports this and returns false.
bool have_pose(const Inputs& inputs, const std::string& name) {
  bool has_all = true;
  for (const Job& job : inputs.jobs) {
    if (job.model == nullptr || !job.obstacles.empty() || joint_positions(*job.model, name)) {
      continue;
    }
    std::vector<std::string_view> known;
    for (const JointPoseSet& pose : job.model->annotations.poses) {
      if (pose.name) known.push_back(*pose.name);
    }
    std::string message = "'" + job.path + "' has no pose '" + name + "'";
    if (const auto near = only_nearest(name, known)) {
      message += "; did you mean '" + std::string(*near) + "'?";
    }
    complain(kTool, message);
    has_all = false;
  }
  return has_all;
}

/// False if it was truncated.
bool is_whole_trace(std::span<const Checked> checked) {
  const auto cut = std::find_if(checked.begin(), checked.end(),
                                [](const Checked& one) { return one.result.is_trace_cut; });
  if (cut == checked.end()) return true;
  complain(kTool, "the trace ends after " + std::to_string(kMostTraceBytes) + " bytes, in '" +
                      cut->job->path + "'; ask for less with --stages or --time");
  return false;
}

bool write_curves(const Options& options, const Run& run) {
  bool is_written = true;
  if (!options.trace.empty()) {
    is_written = write_output(kTool, options.trace, run.trace);
    is_written = is_whole_trace(run.checked) && is_written;
  }
  return is_written;
}

/// Only the findings, for formats without figures.
bool write_reports(const Options& options, const load_check::Report& report) {
  const Results results{report.diagnostics, report.sources, report.summary, {}, kTool};
  bool is_written = true;
  for (const ReportRequest& request : options.reports) {
    if (request.file.empty()) {
      write_error(request.format->render(results, style_for(Stream::error, options.color)));
    } else {
      is_written =
          write_output(kTool, request.file, request.format->render(results, {})) && is_written;
    }
  }
  return is_written;
}

std::vector<std::string> outputs_of(const Options& options) {
  std::vector<std::string> outputs{options.output, options.trace};
  for (const ReportRequest& request : options.reports) outputs.push_back(request.file);
  return outputs;
}

std::vector<Diagnostic> all_diagnostics(std::span<const Checked> checked,
                                        const SourceMap& sources) {
  std::vector<Diagnostic> all;
  for (const Checked& one : checked) {
    all.insert(all.end(), one.result.diagnostics.begin(), one.result.diagnostics.end());
  }
  sort_findings(all, sources);
  return all;
}

}  // namespace

int smurf_load_check_main(int argc, char** argv) {
  prepare_process();
  Options options;
  if (const auto code = parse_command_line(command_of(options), argc, argv)) return *code;
  if (const std::string reason = unusable_engine(); !reason.empty()) {
    complain(kTool, reason);
    return kFailed;
  }
  Inputs inputs(options.input.limits);
  load_inputs(options.input, inputs);
  if (inputs.jobs.empty() && inputs.has_failed) return kFailed;
  if (!options.check.pose.empty() && !have_pose(inputs, options.check.pose)) return kFailed;
  if (!keeps_inputs(kTool, inputs.read, outputs_of(options))) return kFailed;
  options.check.trace = !options.trace.empty();
  const RunOptions how{options.check, options.limits, options.jobs.value_or(1)};
  const Run run = [&] {
    Progress progress("checked", inputs.jobs.size(), options.quiet);
    return run_checks(inputs, how, [&](std::size_t done) { progress.set(done); });
  }();

  load_check::Report report{.checked = run.checked,
                            .diagnostics = all_diagnostics(run.checked, inputs.sources),
                            .sources = inputs.sources,
                            .summary = {},
                            .quiet = options.quiet,
                            .all = options.all};
  report.summary = summary_of(inputs, report.diagnostics);
  const std::string text = options.format == "json"
                               ? render_json(report)
                               : render_text(report, style_for(Stream::output, options.color));
  const bool is_written = write_output(kTool, options.output, text) && write_curves(options, run) &&
                          write_reports(options, report);
  if (!is_written || inputs.has_failed) return kFailed;
  return judge(report.summary, options.threshold);
}
