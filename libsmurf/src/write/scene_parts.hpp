// SPDX-License-Identifier: BSD-3-Clause
// Common parts of the writers for simulators: safe names, groups, bodies, inertia, lights.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "write/placed_shapes.hpp"

namespace smurf {

/// [A-Za-z_][A-Za-z0-9_]*: a name for formats that restrict names; `/` becomes two underscores.
std::string safe_name(std::string_view name);
/// By instance: its path as a unique name for formats that restrict names, [A-Za-z_][A-Za-z0-9_]*.
std::vector<std::string> safe_names(const FlatScene& scene);

/// The model of an instance when it has links; null otherwise.
const LinkedModel* robot_of(const LinkedScene& scene, std::size_t instance);
/// As written; a number for a link without name.
std::string link_name(const LinkedModel& model, std::size_t link);
std::string root_link_name(const LinkedModel& model);
/// The child of a joint; none when it is unknown, or hangs on another joint.
std::optional<std::size_t> carried_link(const LinkedModel& model, std::size_t joint);

/// By instance: the instance at the end of its chain of anchors. Members of one group share it.
/// Anchors may run in a circle; then the first of the circle is the end.
std::vector<std::size_t> anchor_groups(const LinkedScene& scene);

/// The link that an instance is anchored to, by its index in the other instance's model; none when
/// it is not anchored to a link that is known.
std::optional<std::size_t> anchor_link(const LinkedScene& scene, std::size_t instance);
/// X_LE: an instance as seen from the link it is anchored to; none when that link has no pose.
std::optional<Pose> pose_on_anchor(const LinkedScene& scene, std::size_t instance,
                                   LinkFrames& frames);

struct LinkInertial {
  double mass = 0;  ///< kg
  Pose X_LC;        ///< of the centre of mass in the link; the tensor is in its axes
  double ixx = 0, ixy = 0, ixz = 0, iyy = 0, iyz = 0, izz = 0;  ///< kg m^2
};
/// None when the link has no mass.
std::optional<LinkInertial> inertial_of(const urdf::Link& link);
/// For a body that has to have a mass and has none: MARS takes a ball of 10 g and 1 cm radius
/// (mars_core Frame.cpp:601-619).
LinkInertial smallest_mass();
/// The inertial of a solid of uniform density.
LinkInertial solid_mass(const FlatGeometry& geometry, double mass);

/// The defaults of MARS for a scene.
inline constexpr Vector3 kUsualGravity{0, 0, -9.81};  ///< m/s^2
/// s; MARS's 10 ms are too long for the solvers of Gazebo and MuJoCo.
inline constexpr double kUsualStep = 0.001;

/// Position of a joint that starts an instance: given, or following its leader; else 0.
double start_position(const LinkedModel& model, const urdf::Joint& joint,
                      const JointPositions& positions);

/// Whether an entity without model can move, and its mass in kg (MARS: `movable`, `mass`). Old
/// scenes stand still as a whole.
bool is_movable(const FlatInstance& instance);
double mass_of(const FlatInstance& instance);
constexpr double kGroundSize = 100;  ///< sides of the floor of SceneExport::ground, m

/// The lights of the world, in the order of the flat scene.
std::vector<const Light*> world_lights(const SceneExport& scene);
/// Unit vector from a light to where it looks; down when it says nothing.
Vector3 direction_of(const Light& light);
/// The shortest rotation of one unit vector onto another.
Quaternion rotation_onto(const Vector3& from, const Vector3& to);
Rgba color_or(const Field<Color>& color, const Rgba& fallback);

}  // namespace smurf
