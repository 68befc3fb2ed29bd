// SPDX-License-Identifier: BSD-3-Clause
// A stage in which ODE's solver complains is repeated with joints inside their stops. If ODE
// complains again, the stage gets no verdict.
#include "smurf-load-check/stage_run.hpp"

#include <doctest/doctest.h>
#include <ode/ode.h>

#include "base/findings/rules.hpp"
#include "load_check/built.hpp"

using namespace smurf;
using namespace smurf::load_check;

namespace {

void complain() { dMessage(0, "vlambda <= 0, vlambda = %g", 0.0); }

CheckResult run_still(const StageBody& body) {
  start_engine_once();
  const CheckOptions options;
  const OnStage on_stage = [](Stage, const CheckResult&) {};
  StageRun run(options, on_stage, [] { return Named{"joint `j`", {}}; });
  run.stage(Stage::still, body);
  return run.finish();
}

}  // namespace

TEST_CASE("a stage in which ODE complains once more is given no verdict, whatever it measured") {
  int attempts = 0;
  const CheckResult result = run_still([&](StageResult& stage) {
    ++attempts;
    stage.figures.emplace_back();
    complain();
    complain();
  });
  CHECK(attempts == 2);
  REQUIRE(result.stages.size() == 1);
  CHECK(result.stages[0].verdict == Verdict::none);
  CHECK(result.stages[0].figures.empty());
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].rule == &rules::sml6002_no_verdict);
  REQUIRE(result.diagnostics[0].notes.size() == 2);
  CHECK(result.diagnostics[0].notes[0].find("vlambda <= 0") != std::string::npos);
  CHECK(result.diagnostics[0].notes[0].find(", 2 times") != std::string::npos);
  CHECK(result.diagnostics[0].notes[1].find("joint `j`") != std::string::npos);
}

TEST_CASE("a stage in which ODE complains runs again inside the stops, and its note tells") {
  std::vector<double> margins;
  start_engine_once();
  const CheckOptions options;
  const OnStage on_stage = [](Stage, const CheckResult&) {};
  StageRun run(options, on_stage, [] { return Named{}; });
  run.stage(Stage::still, [&](StageResult&) {
    margins.push_back(run.stop_margin());
    if (run.stop_margin() == 0) complain();
  });
  const CheckResult result = run.finish();
  REQUIRE(margins.size() == 2);
  CHECK(margins[1] > 0);
  CHECK(result.diagnostics.empty());
  CHECK(result.stages[0].verdict == Verdict::pass);
  CHECK(result.stages[0].note.find("inside the stops") != std::string::npos);
}

TEST_CASE("a stage in which ODE does not complain runs once and has no note") {
  int attempts = 0;
  const CheckResult result = run_still([&](StageResult&) { ++attempts; });
  CHECK(attempts == 1);
  CHECK(result.stages[0].verdict == Verdict::pass);
  CHECK(result.stages[0].note.empty());
}
