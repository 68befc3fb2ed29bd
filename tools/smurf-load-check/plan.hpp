// SPDX-License-Identifier: BSD-3-Clause
// What is to be built in the physics engine, without the engine: bodies, joints and shapes in the
// world frame, links that do not move against each other being one body.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "convert/mass_properties.hpp"
#include "smurf-load-check/joint_forms.hpp"
#include "smurf/linked.hpp"

namespace smurf::load_check {

/// The body that never moves: what is fixed to the world.
inline constexpr std::size_t kWorld = std::numeric_limits<std::size_t>::max();
/// The body of the ground, of planes and of heightfields; unlike kWorld it is no part of a robot.
inline constexpr std::size_t kEnvironment = kWorld - 1;

/// What the root link of a model is attached to.
struct Base {
  enum class Kind : std::uint8_t { free, world, link };
  Kind kind = Kind::free;
  std::size_t instance = 0;  ///< kind link
  LinkIndex link{};          ///< kind link
};

/// A model to build: one instance of a plan. Its tree has one root.
struct PlacedModel {
  const LinkedModel* model = nullptr;
  std::string name;  ///< of the entity; empty for a model on its own
  Pose X_WR;         ///< of the root link
  JointPositions positions;
  Base base;
};

struct LinkPlan {
  std::size_t instance = 0;
  LinkIndex link{};
  std::size_t body = kWorld;
  Pose X_WL;
};

struct BodyPlan {
  std::size_t first_link = 0;  ///< in Plan::links: the one nearest to the root
  MassProperties mass;         ///< in the world frame, at the start
  bool is_stand_in = false;    ///< the mass is not the written one, which ODE refuses
};

struct JointPlan {
  JointKind kind = JointKind::hinge;
  std::size_t instance = 0;
  JointIndex joint{};
  std::size_t parent = kWorld, child = kWorld;  ///< bodies
  Eigen::Vector3d anchor_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis2_W = Eigen::Vector3d::Zero();  ///< universal; turns with the child
  Span form_place;                                    ///< as in JointForm
  double start = 0;                                   ///< position at the start; rad or m
  std::optional<std::pair<double, double>> limits;    ///< of the URDF; rad or m
  std::optional<std::pair<double, double>> stops;     ///< the limits where ODE can express them
};

struct BoxShape {
  Eigen::Vector3d size;
};
struct SphereShape {
  double radius;
};
struct CylinderShape {
  double radius, length;
};
struct CapsuleShape {
  double radius, length;  ///< `length` of the cylindrical part
};
struct TriangleShape {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
/// All below the x-y plane of the shape's frame.
struct PlaneShape {};
/// Heights over the x-y plane of the shape's frame, the frame in the middle.
struct HeightfieldShape {
  double size_x, size_y;       ///< m
  std::size_t columns, rows;   ///< along x and y; at least 2
  std::vector<float> heights;  ///< by row from -y to +y; m
};
using Shape = std::variant<BoxShape, SphereShape, CylinderShape, CapsuleShape, TriangleShape,
                           PlaneShape, HeightfieldShape>;

struct ShapePlan {
  std::size_t instance = 0;
  LinkIndex link{};
  std::size_t collision = 0;  ///< of the link
  std::string name;           ///< for messages: "collision `x`"
  Span place;
  std::size_t body = kWorld;
  Pose X_WS;
  Shape shape;
  std::uint64_t bitmask = 65535;  ///< as in MARS: two shapes touch when their masks share a bit
  /// A stand-in that is larger than the shape; it touches the environment only.
  bool is_stand_in = false;
};

struct Plan {
  std::vector<PlacedModel> models;
  std::vector<LinkPlan> links;  ///< by model, in tree order
  std::vector<BodyPlan> bodies;
  std::vector<JointPlan> joints;
  std::vector<ShapePlan> shapes;
  std::size_t unbounded_joints = 0;  ///< whose limits no stop can express

  const LinkedModel& model_of(const LinkPlan& link) const { return *models[link.instance].model; }
  const urdf::Link& link(const LinkPlan& link) const { return model_of(link).link(link.link); }
  const urdf::Joint& joint(const JointPlan& joint) const {
    return models[joint.instance].model->joint(joint.joint);
  }
};

/// Bodies and joints; shapes are added by add_shapes(). Masses are summed up as they are written,
/// whether a body can have them or not. Precondition: every model has a robot with one root, and
/// bases lead to no circle.
Plan make_plan(std::vector<PlacedModel> models);

Eigen::Vector3d to_eigen(const Vector3& vector);
Eigen::Vector3d to_world(const Pose& X_WA, const Eigen::Vector3d& p_A);
/// The limits of the URDF (rad or m), which are those of its own kind of joint; none when they
/// contradict each other.
std::optional<std::pair<double, double>> limits_of(const urdf::Joint& joint, JointKind kind);
/// Length of the joint's axis as written; 1 when it is left out.
double axis_length(const urdf::Joint& joint);

}  // namespace smurf::load_check
