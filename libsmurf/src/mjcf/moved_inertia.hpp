// SPDX-License-Identifier: BSD-3-Clause
// The inertia that each joint moves while all others hold still.
#pragma once

#include <optional>
#include <vector>

#include "mjcf/model.hpp"

namespace smurf::mjcf {

/// Of a model with all joints at their reference, as MuJoCo computes its constants.
class MovedInertia {
 public:
  explicit MovedInertia(const Model& model);

  /// With the armature: kg m^2 about a hinge, kg along a slide; of a ball, the mean of three axes.
  /// None if a mass that it moves is unknown.
  std::optional<double> of(const Joint& joint, std::size_t body) const;

 private:
  std::vector<Pose> X_WB_;
  /// Of a body and all below it, in the world; none: unknown.
  std::vector<std::optional<MassProperties>> carried_;
};

}  // namespace smurf::mjcf
