// SPDX-License-Identifier: BSD-3-Clause
// Common parts of the writers for simulators: safe names, groups, bodies, inertia, lights.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "write/parts/placed_shapes.hpp"

namespace smurf {

/// [A-Za-z_][A-Za-z0-9_]*: a name for formats that restrict names; `/` becomes two underscores.
std::string safe_name(std::string_view name);
/// By instance: its path as a unique name for formats that restrict names, [A-Za-z_][A-Za-z0-9_]*.
std::vector<std::string> safe_names(const FlatScene& scene);

/// The model of an instance if it has links; null otherwise.
const LinkedModel* robot_of(const LinkedScene& scene, std::size_t instance);
/// The name of a link as written; a number for a link without name.
std::string link_name(const LinkedModel& model, std::size_t link);
std::string root_link_name(const LinkedModel& model);
/// The child of a joint; none if it is unknown, or has another parent joint.
std::optional<std::size_t> carried_link(const LinkedModel& model, std::size_t joint);

/// Whether a joint leads to a link that another joint carries.
bool closes_loop(const LinkedModel& model, std::size_t joint);

/// By instance: the instance at the end of its chain of anchors, which identifies a group. In a
/// cycle of anchors, it is the first instance of the cycle.
std::vector<std::size_t> anchor_groups(const FlatScene& scene);

/// The link that an instance is anchored to, as an index in the other instance's model; none if it
/// is not anchored to a known link.
std::optional<std::size_t> anchor_link(const SceneExport& scene, std::size_t instance);
/// X_LE: the pose of an instance in the frame of its anchor link; none if that link has no pose.
std::optional<Pose> pose_on_anchor(const SceneExport& scene, std::size_t instance,
                                   LinkFrames& frames);

struct LinkInertial {
  double mass = 0;  ///< kg
  Pose X_LC;        ///< centre of mass in the link; the tensor has the axes of the link
  double ixx = 0, ixy = 0, ixz = 0, iyy = 0, iyz = 0, izz = 0;  ///< kg m^2
};
/// None if the link has no mass.
std::optional<LinkInertial> inertial_of(const urdf::Link& link);
/// For a body without mass in a format that requires one: MARS uses a ball of 10 g and 1 cm radius
/// (mars_core Frame.cpp:601-619).
LinkInertial smallest_mass();
/// The inertial of a solid of uniform density.
LinkInertial solid_mass(const FlatGeometry& geometry, double mass);

/// The defaults of MARS for a scene.
inline constexpr Vector3 kUsualGravity{0, 0, -9.81};  ///< m/s^2
/// s; MARS's 10 ms are too long for the solvers of Gazebo and MuJoCo.
inline constexpr double kUsualStep = 0.001;
inline constexpr double kGroundSize = 100;  ///< sides of the floor of SceneExport::ground, m

/// The start position of a joint of an instance: given, or computed from its leader; otherwise 0.
double start_position(const LinkedModel& model, const urdf::Joint& joint,
                      const JointPositions& positions);

/// The axis of a joint for simulators, which refuse axes near zero: a very short or long one has
/// length 1 here. None if it is zero.
std::optional<Vector3> joint_axis(const urdf::Joint& joint);

/// Whether an entity without model can move, and its mass in kg (MARS: `movable`, `mass`). Old
/// scenes do not move.
bool is_movable(const FlatInstance& instance);
double mass_of(const FlatInstance& instance);
/// Whether an instance stays where it is: a model anchored to the world, or another entity with a
/// shape that cannot move. MARS ignores the anchor of a primitive.
bool is_fixed_to_world(const FlatInstance& instance);

/// The lights of the world, in the order of the flat scene.
std::vector<const Light*> world_lights(const SceneExport& scene);
/// Unit vector in the direction of a light; down by default.
Vector3 direction_of(const Light& light);
/// The shortest rotation of one unit vector onto another.
Quaternion rotation_onto(const Vector3& from, const Vector3& to);
Rgba color_or(const Field<Color>& color, const Rgba& fallback);

}  // namespace smurf
