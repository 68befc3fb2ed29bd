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
  std::string pose;            ///< name of a joint pose; empty: near zero
  std::optional<double> time;  ///< s, of every timed stage
  std::optional<double> step;  ///< s
  Bounds bounds;
  bool trace = false;  ///< fill CheckResult::trace
  std::size_t most_trace_bytes = kMostTraceBytes;
  std::string traced_as;  ///< name of the file in rows of the trace
};

/// Called before a stage begins, with the result of earlier stages but without their samples.
using OnStage = std::function<void(Stage, const CheckResult& so_far)>;

/// Checks one model: BUILD, POSE0, STILL, HANG, DROP. Parts that BUILD refuses are replaced in the
/// other stages. Of these, the first that fails is the last one run. Precondition: the model has a
/// robot with one root.
CheckResult check_model(const LinkedModel& model, const ShapeFiles& files,
                        const CheckOptions& options, const OnStage& on_stage);

/// Checks a whole scene, with all entities in their places: BUILD, POSE0, ANCHOR. Gravity and step
/// come from the scene. Precondition: the model of every instance has a robot with one root.
CheckResult check_scene(const LinkedScene& scene, const SourceMap& sources, const ShapeFiles& files,
                        const CheckOptions& options, const OnStage& on_stage);

}  // namespace smurf::load_check
