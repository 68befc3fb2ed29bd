// SPDX-License-Identifier: BSD-3-Clause
// Inertias that simulators accept: they refuse a whole world because of an impossible one.
#pragma once

#include "write/parts/scene_parts.hpp"

namespace smurf {

struct BodyInertia {
  LinkInertial mass;
  /// Whether `mass` contains principal moments, ascending, with their axes in X_LC. Otherwise, it
  /// is the inertial of the link as written: moments above the bound, the largest at most the sum
  /// of the others.
  bool is_principal = false;
  bool is_changed = false;  ///< the change is larger than rounding
};

/// The nearest inertia of a possible body whose mass and moments are at least `least` (kg, kg m^2).
/// Moments up to `least_in_tensor` are given by principal moments.
BodyInertia body_inertia(const LinkInertial& mass, double least, double least_in_tensor);

/// The same, always with principal moments, for readers that only refuse moments below `least`.
BodyInertia principal_inertia(const LinkInertial& mass, double least);

/// The inertial that a link gets in a simulator.
struct ChosenMass {
  LinkInertial mass;
  std::string_view chosen;  ///< the row of the table of losses that says so; "": as written
};
/// That of the link; where it has none, or one with which nothing can move, that of its shapes.
ChosenMass link_mass(const LinkedModel& model, const urdf::Link& link);
/// The same; those that the scene keeps are as they were.
ChosenMass link_mass(const SceneExport& scene, const LinkedModel& model, const urdf::Link& link);
/// Adds the links of a model whose tensor of 1 kg m^2 is meant: those of a language of simulators,
/// and those whose annotation keeps it.
void keep_meant_tensors(const LinkedModel& model, KeptMasses& masses);

/// R I R^T: the tensor in the axes of the link; xx, yy, zz, xy, xz, yz.
std::array<double, 6> tensor_in_link(const LinkInertial& mass);

}  // namespace smurf
