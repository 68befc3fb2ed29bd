// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/check_processes.hpp"

#include <algorithm>
#include <utility>

#include "base/findings/rules.hpp"
#include "smurf-load-check/bodies.hpp"
#include "smurf-load-check/trace.hpp"
#include "smurf-load-check/wire.hpp"
#include "smurf-load-check/world.hpp"
#include "smurf/lint.hpp"

namespace smurf::load_check {
namespace {

using Write = std::function<void(const std::string&)>;

/// For the fault handler, which ODE calls without a context. There is one check per process.
const Write* fault_output = nullptr;

void on_fault(const std::string& message) {
  (*fault_output)(encode_fault(message));
  end_child();
}

/// Returns the size of the trace.
std::size_t run_job(const Job& job, const Inputs& inputs, CheckOptions options,
                    const Write& write) {
  options.traced_as = field_of(job.path);
  fault_output = &write;
  start_engine(on_fault);
  const auto on_stage = [&](Stage stage, const CheckResult& so_far) {
    write(encode(so_far) + encode_begin(stage));
  };
  const ShapeFiles files{inputs.files, inputs.limits};
  const CheckResult result =
      job.model != nullptr ? check_model(*job.model, files, options, on_stage)
                           : check_scene(*job.scene, inputs.sources, files, options, on_stage);
  if (options.trace) {
    write(encode_trace_begin(result.trace.size()));
    write(result.trace);
  }
  write(encode(result));
  return result.trace.size();
}

Span place_of(const Job& job) {
  if (job.model != nullptr) return load_check::place_of(*job.model);
  return {job.scene->scenes.front().source, 0, 0};
}

std::string reason(const ChildOutcome& outcome, const ChildLimits& limits) {
  switch (outcome.end) {
  case ChildOutcome::End::out_of_time:
    return "takes more than " + std::to_string(limits.seconds) + " s of processor time";
  case ChildOutcome::End::no_time_left:
    return "was not started: the models of the scene take more than " +
           std::to_string(limits.seconds) + " s of processor time together";
  case ChildOutcome::End::out_of_memory:
    return "takes more than " + std::to_string(limits.memory_bytes >> 20U) + " MB";
  case ChildOutcome::End::not_started: return "cannot be started: no more processes";
  case ChildOutcome::End::crashed:
  case ChildOutcome::End::finished: break;
  }
  return "";
}

/// The result of a child that ended early.
CheckResult broken_off(const Job& job, const ChildOutcome& outcome, const Message& message,
                       const ChildLimits& limits) {
  const Stage stage = message.last_stage.value_or(Stage::build);
  const std::string in_stage = "stage " + std::string(to_string(stage));
  DiagnosticSink sink;
  const std::string why = reason(outcome, limits);
  if (!why.empty()) {
    sink.report(rules::sml6002_no_verdict, place_of(job), in_stage + " " + why);
  } else {
    Diagnostic& diagnostic =
        sink.report(rules::sml6001_engine_gives_up, place_of(job), "ODE gives up in " + in_stage);
    diagnostic.caret = message.fault.empty() ? "killed by signal " + std::to_string(outcome.signal)
                                             : message.fault;
  }
  CheckResult result = message.so_far;
  StageResult failed;
  failed.stage = stage;
  failed.verdict = why.empty() ? Verdict::fail : Verdict::none;
  failed.note = "broken off";
  result.stages.push_back(std::move(failed));
  for (Diagnostic& diagnostic : sink.take()) result.diagnostics.push_back(std::move(diagnostic));
  return result;
}

CheckResult result_of(const Job& job, ChildOutcome outcome, const ChildLimits& limits,
                      const Session& session) {
  Message message = decode(std::move(outcome.output));
  CheckResult result =
      message.result ? std::move(*message.result) : broken_off(job, outcome, message, limits);
  result.diagnostics = job.model != nullptr
                           ? session.settle(*job.loaded, *job.model, std::move(result.diagnostics))
                           : session.settle(*job.loaded, std::move(result.diagnostics));
  return result;
}

}  // namespace

Verdict Checked::verdict() const {
  if (result.stages.empty()) return Verdict::fail;
  Verdict worst = Verdict::pass;
  for (const StageResult& stage : result.stages) {
    if (stage.verdict != Verdict::skipped) worst = std::max(worst, stage.verdict);
  }
  return worst;
}

Tally tally_of(std::span<const Checked> checked) {
  Tally tally;
  for (const Checked& one : checked) {
    switch (one.verdict()) {
    case Verdict::pass: ++tally.passed; break;
    case Verdict::warn: ++tally.warned; break;
    case Verdict::none: ++tally.undecided; break;
    case Verdict::fail:
    case Verdict::skipped: ++tally.failed; break;
    }
  }
  return tally;
}

Run run_checks(const Inputs& inputs, const RunOptions& options,
               const std::function<void(std::size_t)>& on_finished) {
  Run run;
  run.trace = kTraceHeading;
  std::vector<std::size_t> to_run;
  std::vector<std::size_t> groups;  // jobs of one input share the time
  for (const Job& job : inputs.jobs) {
    if (job.obstacles.empty()) {
      const bool is_new = to_run.empty() || run.checked[to_run.back()].job->loaded != job.loaded;
      groups.push_back(groups.empty() ? 0 : groups.back() + (is_new ? 1 : 0));
      to_run.push_back(run.checked.size());
    }
    run.checked.push_back({&job, {}});
    run.checked.back().result.diagnostics = job.obstacles;
  }
  std::size_t sent = 0;  // bytes of traces from this child
  const auto task = [&](std::size_t i, const Write& write) {
    CheckOptions check = options.check;
    check.most_trace_bytes = kMostTraceBytes - run.trace.size() - sent;
    sent += run_job(*run.checked[to_run[i]].job, inputs, std::move(check), write);
  };
  std::size_t finished = 0;
  const auto keep = [&](std::size_t i, ChildOutcome outcome) {
    Checked& one = run.checked[to_run[i]];
    one.result = result_of(*one.job, std::move(outcome), options.limits, inputs.session);
    run.trace += std::exchange(one.result.trace, {});
    on_finished(++finished);
  };
  const int jobs = options.check.trace ? 1 : options.jobs;
  run_in_children(groups, jobs, options.limits, task, keep);
  return run;
}

}  // namespace smurf::load_check
