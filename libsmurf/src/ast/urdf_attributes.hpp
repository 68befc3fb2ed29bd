// SPDX-License-Identifier: BSD-3-Clause
// The attributes of URDF as tables, one per element. A row states name, meaning and member of an
// attribute; the checks, the reader, help, completion, comparison, canonical form, dump and the
// Python module use it.
// Sources: urdfdom 3.0.1 and 5.x parsers, the URDF XML specification on the ROS wiki.
#pragma once

#include <array>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "ast/urdf_schema.hpp"
#include "smurf/urdf.hpp"

namespace smurf::urdf {

/// In the order of the forms in urdf_schema.cpp.
template <class T>
using Member = std::variant<std::monostate, Field<std::string> T::*, Field<double> T::*,
                            Field<Vector3> T::*, Field<std::array<double, 4>> T::*>;

/// An attribute and the member for its value; without a member, the value is only in the tree.
template <class T>
struct Attribute {
  AttributeSpec spec;
  Member<T> member = {};
};

/// The table of an element that is read into `T`. Functions find out `T` by their other arguments.
template <class T>
using Rows = std::type_identity_t<std::span<const Attribute<std::remove_const_t<T>>>>;

/// Calls `use(spec, field)` for each attribute of `object` that has a member.
template <class T, class Use>
void for_each_field(Rows<T> rows, T& object, const Use& use) {
  for (const auto& row : rows) {
    std::visit(
        [&](auto member) {
          if constexpr (!std::is_same_v<decltype(member), std::monostate>) {
            use(row.spec, object.*member);
          }
        },
        row.member);
  }
}

using enum Need;

/// An attribute that has this name in the dump and in Python.
constexpr AttributeSpec shown_as(std::string_view key, AttributeSpec spec) {
  spec.key = key;
  return spec;
}
/// An attribute that names a thing of this kind.
constexpr AttributeSpec names(NameKind kind, AttributeSpec spec) {
  spec.names = kind;
  return spec;
}
constexpr AttributeSpec path(AttributeSpec spec) {
  spec.is_path = true;
  return spec;
}
/// An attribute that the canonical form writes after those of the other rows.
constexpr AttributeSpec last(AttributeSpec spec) {
  spec.is_last = true;
  return spec;
}

inline constexpr Attribute<Robot> kRobot[] = {
    {{"name", optional, "Name of the robot."}, &Robot::name},
    {{"version", optional,
      "Version of URDF; urdfdom accepts 1.0, its newer versions also 1.1 and 1.2.", "", "1.0"},
     &Robot::version}};

inline constexpr Attribute<Link> kLink[] = {
    {{"name", required,
      "Name of the link; joints, motors and sensors refer to it, so it is unique."},
     &Link::name},
    {{.name = "type", .doc = "From old files; readers ignore it.", .form = Form::text}}};

inline constexpr Attribute<Inertial> kMass[] = {
    {shown_as("mass", {"value", required, "Mass of the link.", "kg"}), &Inertial::mass}};
// Separate rules report missing entries of a tensor and entries below its diagonal.
inline constexpr Attribute<Inertial> kInertia[] = {
    {{"ixx", usual, "Moment about the x axis through the centre of mass.", "kg m^2"},
     &Inertial::ixx},
    {{"ixy", usual, "Product of inertia: minus the integral of x y.", "kg m^2"}, &Inertial::ixy},
    {{"ixz", usual, "Product of inertia: minus the integral of x z.", "kg m^2"}, &Inertial::ixz},
    {{"iyy", usual, "Moment about the y axis through the centre of mass.", "kg m^2"},
     &Inertial::iyy},
    {{"iyz", usual, "Product of inertia: minus the integral of y z.", "kg m^2"}, &Inertial::iyz},
    {{"izz", usual, "Moment about the z axis through the centre of mass.", "kg m^2"},
     &Inertial::izz}};
/// Their names.
inline constexpr auto kInertiaEntries = [] {
  std::array<std::string_view, std::size(kInertia)> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kInertia[i].spec.name;
  return names;
}();
inline constexpr Attribute<Origin> kOrigin[] = {
    {{"xyz", usual, "Position in the frame of the enclosing element.", "m", "0 0 0"}, &Origin::xyz},
    {{"rpy", optional, "Rotation about the fixed axes x, then y, then z.", "rad", "0 0 0"},
     &Origin::rpy},
    // Its value is read into `rpy`.
    {{.name = "quat_xyzw",
      .doc = "Rotation as a quaternion; read since version 1.1 of URDF.",
      .form = Form::four_numbers}}};

inline constexpr Attribute<Visual> kVisual[] = {
    {{"name", optional, "Name of the visual."}, &Visual::name}};
inline constexpr Attribute<Collision> kCollision[] = {
    {{"name", optional, "Name of the collision."}, &Collision::name}};

inline constexpr AttributeSpec kRadius = {"radius", required, "Radius.", "m"};
inline constexpr Attribute<Box> kBox[] = {
    {{"size", required, "Full lengths of the edges along x, y and z.", "m"}, &Box::size}};
inline constexpr Attribute<Sphere> kSphere[] = {{kRadius, &Sphere::radius}};
inline constexpr Attribute<Cylinder> kCylinder[] = {
    {kRadius, &Cylinder::radius},
    {{"length", required, "Length along z.", "m"}, &Cylinder::length}};
inline constexpr Attribute<Capsule> kCapsule[] = {
    {kRadius, &Capsule::radius},
    {{"length", required, "Length along z, without the half spheres.", "m"}, &Capsule::length}};
inline constexpr Attribute<Mesh> kMesh[] = {
    {last(path({"filename", required, "The mesh: a path, or package://NAME/PATH."})),
     &Mesh::filename},
    {{"scale", optional, "Factors along x, y and z.", "", "1 1 1"}, &Mesh::scale}};

inline constexpr Attribute<Material> kMaterial[] = {
    {names(NameKind::material, {"name", required, "Name of the material."}), &Material::name}};
inline constexpr Attribute<Material> kColor[] = {
    {{"rgba", required, "Red, green, blue and alpha, each from 0 to 1."}, &Material::rgba}};
inline constexpr Attribute<Material> kTexture[] = {
    {shown_as("texture", path({"filename", usual, "The image: a path, or package://NAME/PATH."})),
     &Material::texture}};

/// In the order of JointType.
inline constexpr std::string_view kJointTypes[] = {"revolute", "continuous", "prismatic",
                                                   "fixed",    "floating",   "planar"};
inline constexpr Attribute<Joint> kJoint[] = {
    {{"name", required, "Name of the joint; motors and sensors refer to it, so it is unique."},
     &Joint::name},
    {{.name = "type",
      .need = usual,
      .doc = "How the child moves relative to the parent.",
      .values = kJointTypes},
     &Joint::type_name}};
inline constexpr Attribute<Joint> kParent[] = {
    {shown_as("parent", names(NameKind::link, {"link", usual, "Name of the parent link."})),
     &Joint::parent}};
inline constexpr Attribute<Joint> kChild[] = {
    {shown_as("child", names(NameKind::link, {"link", usual, "Name of the child link."})),
     &Joint::child}};
inline constexpr Attribute<Joint> kAxis[] = {
    {shown_as("axis",
              {"xyz", required, "Direction in the joint's frame, of length 1.", "", "1 0 0"}),
     &Joint::axis}};
inline constexpr Attribute<Limit> kLimit[] = {
    {{"lower", usual, "Lowest position.", "rad or m", "0"}, &Limit::lower},
    {{"upper", usual, "Highest position.", "rad or m", "0"}, &Limit::upper},
    {{"effort", usual, "Largest torque or force.", "N m or N"}, &Limit::effort},
    {{"velocity", usual, "Largest speed.", "rad/s or m/s"}, &Limit::velocity},
    {{"acceleration", optional, "Largest acceleration; read since version 1.2 of URDF.",
      "rad/s^2 or m/s^2"}},
    {{"deceleration", optional, "Largest deceleration; read since version 1.2 of URDF.",
      "rad/s^2 or m/s^2"}},
    {{"jerk", optional, "Largest jerk; read since version 1.2 of URDF.", "rad/s^3 or m/s^3"}}};
inline constexpr Attribute<Dynamics> kDynamics[] = {
    {{"damping", optional, "Viscous damping.", "N m s/rad or N s/m", "0"}, &Dynamics::damping},
    {{"friction", optional, "Static friction.", "N m or N", "0"}, &Dynamics::friction}};
inline constexpr Attribute<Mimic> kMimic[] = {
    {names(NameKind::joint, {"joint", required, "Joint that this one follows."}), &Mimic::joint},
    {{"multiplier", optional, "Factor on the position of that joint.", "", "1"},
     &Mimic::multiplier},
    {{"offset", optional, "Offset that is added to the result.", "rad or m", "0"}, &Mimic::offset}};
inline constexpr Attribute<SafetyController> kSafetyController[] = {
    {last({"soft_lower_limit", optional, "Where the controller begins to limit the position.",
           "rad or m", "0"}),
     &SafetyController::soft_lower_limit},
    {last({"soft_upper_limit", optional, "Where the controller begins to limit the position.",
           "rad or m", "0"}),
     &SafetyController::soft_upper_limit},
    {last({"k_position", optional, "Relation between position and velocity limits.", "", "0"}),
     &SafetyController::k_position},
    {last({"k_velocity", required, "Relation between effort and velocity limits."}),
     &SafetyController::k_velocity}};
inline constexpr Attribute<Calibration> kCalibration[] = {
    {last({"rising", optional, "Position at which the reference rises.", "rad or m"}),
     &Calibration::rising},
    {last({"falling", optional, "Position at which the reference falls.", "rad or m"}),
     &Calibration::falling},
    {last({"reference_position", optional, "Position of the reference mark.", "rad or m"})}};

constexpr std::string_view name_of(JointType type) {
  return type == JointType::unknown ? "unknown" : kJointTypes[static_cast<std::size_t>(type)];
}
constexpr JointType joint_type(std::string_view name) {
  std::size_t i = 0;
  while (i < std::size(kJointTypes) && kJointTypes[i] != name) ++i;
  return static_cast<JointType>(i);
}

}  // namespace smurf::urdf
