// SPDX-License-Identifier: BSD-3-Clause
// The inertia that each joint moves.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "mjcf/model.hpp"

namespace smurf::mjcf {

/// Of a model with all joints at their reference, as MuJoCo computes its constants.
class MovedInertia {
 public:
  explicit MovedInertia(const Model& model);

  /// While all other joints hold still, with the armature: kg m^2 about a hinge, kg along a slide;
  /// of a ball, the mean of three axes. None if a mass that it moves is unknown.
  std::optional<double> locked(const Joint& joint, std::size_t body) const;
  /// While all other joints move freely, of a hinge or a slide. None if a mass is unknown, or if
  /// the model has so many joints that this would take long.
  std::optional<double> free(const Joint& joint);

 private:
  void find_free();

  const Model& model_;
  std::vector<Pose> X_WB_;
  /// Of a body and all below it, in the world; none: unknown.
  std::vector<std::optional<MassProperties>> carried_;
  bool has_free_ = false;
  std::map<const Joint*, double> free_;
};

}  // namespace smurf::mjcf
