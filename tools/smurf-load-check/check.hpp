// SPDX-License-Identifier: BSD-3-Clause
// The stages of a check, one after the other. Runs ODE: call it in a child process.
#pragma once

#include <functional>
#include <optional>
#include <set>

#include "smurf-load-check/bounds.hpp"
#include "smurf-load-check/result.hpp"
#include "smurf-load-check/shape_files.hpp"
#include "smurf/linked.hpp"

namespace smurf::load_check {

struct CheckOptions {
  std::set<Stage> stages{Stage::build, Stage::pose0, Stage::still,
                         Stage::hang,  Stage::drop,  Stage::anchor};  ///< BUILD is always run
  std::string pose;                                                   ///< named; empty: near zero
  std::optional<double> time;                                         ///< s, of every timed stage
  std::optional<double> step;                                         ///< s
  Bounds bounds;
  bool samples = false;  ///< fill CheckResult::samples
  bool trace = false;    ///< fill CheckResult::trace
  std::size_t most_trace_bytes = kMostTraceBytes;
  std::string traced_as;  ///< what rows of the trace call the file
};

/// Called before a stage begins, with the result of those before it but their samples.
using OnStage = std::function<void(Stage, const CheckResult& so_far)>;

/// One model on its own: BUILD, POSE0, STILL, HANG, DROP. What BUILD refuses has a stand-in in the
/// other stages; of those, one that fails is the last that is run. Precondition: the model has a
/// robot with one root.
CheckResult check_model(const LinkedModel& model, const ShapeFiles& files,
                        const CheckOptions& options, const OnStage& on_stage);

/// A scene as a whole, all entities in their places: BUILD, POSE0, ANCHOR. Gravity and step are the
/// scene's. Precondition: every model of an instance has a robot with one root.
CheckResult check_scene(const LinkedScene& scene, const SourceMap& sources, const ShapeFiles& files,
                        const CheckOptions& options, const OnStage& on_stage);

}  // namespace smurf::load_check
