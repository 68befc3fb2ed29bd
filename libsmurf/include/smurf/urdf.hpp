// SPDX-License-Identifier: BSD-3-Clause
// A URDF as its author wrote it: in document order, with duplicates and without defaults.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "smurf/pose.hpp"
#include "smurf/source.hpp"
#include "smurf/xml.hpp"

namespace smurf::urdf {

/// A pose element. Units: metres, radians (fixed-axis roll, pitch, yaw).
struct Origin {
  xml::ElementId element = xml::kNoElement;  ///< kNoElement if absent
  Field<Vector3> xyz;
  Field<Vector3> rpy;
};

/// The rigid transform of an origin; absent parts are zero.
Pose to_pose(const Origin& origin);

/// Mass and inertia of a link.
struct Inertial {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Origin origin;
  Field<double> mass;  ///< kg
  /// kg m^2 about the centre of mass, in the inertial frame.
  Field<double> ixx, ixy, ixz, iyy, iyz, izz;
};

/// Centred on its origin.
struct Box {
  Field<Vector3> size;  ///< full edge lengths, m
};
/// Centred on its origin.
struct Sphere {
  Field<double> radius;  ///< m
};
/// Centred on its origin, along z.
struct Cylinder {
  Field<double> radius;  ///< m
  Field<double> length;  ///< m, along z
};
/// A cylinder with two hemispheres, centred on its origin, along z.
struct Capsule {
  Field<double> radius;  ///< m
  Field<double> length;  ///< m, of the cylindrical part
};
/// A mesh with the file name in the URDF. LinkedModel::meshes has the file that was found.
struct Mesh {
  Field<std::string> filename;
  Field<Vector3> scale;
};
/// `std::monostate`: no geometry, or a shape URDF does not know.
using Shape = std::variant<std::monostate, Box, Sphere, Cylinder, Capsule, Mesh>;

/// The shape of a visual or collision.
struct Geometry {
  xml::ElementId element = xml::kNoElement;        ///< `geometry`
  xml::ElementId shape_element = xml::kNoElement;  ///< its first child
  Shape shape;
};

/// A material of the robot, or a material that a visual defines or names.
struct Material {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<std::string> name;
  Field<std::array<double, 4>> rgba;  ///< 0..1
  Field<std::string> texture;
};

/// The appearance of a link.
struct Visual {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<std::string> name;
  Origin origin;
  Geometry geometry;
  std::optional<Material> material;
};

/// The shape of a link for collisions.
struct Collision {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<std::string> name;
  Origin origin;
  Geometry geometry;
};

/// A rigid body with its frame.
struct Link {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<std::string> name;
  std::optional<Inertial> inertial;
  std::vector<Visual> visuals;
  std::vector<Collision> collisions;
};

/// The kinds of motion between parent and child link.
enum class JointType : std::uint8_t {
  revolute,
  continuous,
  prismatic,
  fixed,
  floating,
  planar,
  unknown  ///< absent, or unknown in URDF
};

/// The range of a joint and the limits of its motor.
struct Limit {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<double> lower, upper;  ///< rad or m
  Field<double> effort;        ///< N m or N
  Field<double> velocity;      ///< rad/s or m/s
};

/// Damping and friction of a joint.
struct Dynamics {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<double> damping;   ///< N m s/rad or N s/m
  Field<double> friction;  ///< N m or N
};

/// A joint that follows another one: its position is multiplier * position + offset.
struct Mimic {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<std::string> joint;
  Field<double> multiplier;
  Field<double> offset;  ///< rad or m
};

/// Bounds that a controller keeps before the hard limits.
struct SafetyController {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<double> soft_lower_limit, soft_upper_limit;  ///< rad or m
  Field<double> k_position;                          ///< 1/s
  Field<double> k_velocity;                          ///< N m s/rad or N s/m
};

/// Positions of the edges of a reference signal, rad or m.
struct Calibration {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<double> rising, falling;
};

/// Connects two links. The joint and its axis are in the frame of the child at position 0.
struct Joint {
  xml::ElementId element = xml::kNoElement;
  Span span;
  Field<std::string> name;
  Field<std::string> type_name;
  JointType type = JointType::unknown;
  Origin origin;
  Field<std::string> parent, child;
  xml::ElementId axis_element = xml::kNoElement;
  Field<Vector3> axis;  ///< as written, in the joint frame; not normalised
  std::optional<Limit> limit;
  std::optional<Dynamics> dynamics;
  // On the heap, because few joints have these members and each is large.
  std::unique_ptr<Mimic> mimic;
  std::unique_ptr<SafetyController> safety_controller;
  std::unique_ptr<Calibration> calibration;

  bool is_movable() const { return type != JointType::fixed && type != JointType::unknown; }
  bool has_one_axis() const {
    return type == JointType::revolute || type == JointType::continuous ||
           type == JointType::prismatic;
  }
};

/// A URDF. Links and joints are in the order of the file.
struct Robot {
  xml::Document document;  ///< all elements, unknown ones included
  Field<std::string> name;
  Field<std::string> version;
  std::vector<Material> materials;  ///< of the robot level
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<xml::ElementId> extensions;  ///< other children: transmission, gazebo, sensor, ...
};

}  // namespace smurf::urdf
