// SPDX-License-Identifier: BSD-3-Clause
// The plan for the physics engine, independent of it: bodies, joints and shapes in the world frame.
// Links that do not move relative to each other are one body.
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

/// The body that never moves: links fixed to the world.
inline constexpr std::size_t kWorld = std::numeric_limits<std::size_t>::max();
/// The body of the ground, planes and heightfields; unlike kWorld, it is not part of a robot.
inline constexpr std::size_t kEnvironment = kWorld - 1;

/// The base of the root link of a model.
struct Base {
  enum class Kind : std::uint8_t { free, world, link };
  Kind kind = Kind::free;
  std::size_t instance = 0;  ///< kind link
  LinkIndex link{};          ///< kind link
};

/// A model to build: one instance of a plan. Its tree has one root.
struct PlacedModel {
  const LinkedModel* model = nullptr;
  std::string name;  ///< path of the entity; empty for a single model
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
  std::size_t first_link = 0;  ///< index in Plan::links: the link nearest to the root
  MassProperties mass;         ///< in the world frame, at the start
  bool is_stand_in = false;    ///< the mass differs from the written one, which ODE refuses
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
  std::optional<std::pair<double, double>> limits;    ///< limits of the URDF; rad or m
  std::optional<std::pair<double, double>> stops;     ///< the limits that ODE can express
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
/// The half space below the x-y plane of the shape's frame.
struct PlaneShape {};
/// Heights over the x-y plane of the shape's frame, centred at its origin.
struct HeightfieldShape {
  double size_x, size_y;       ///< m
  std::size_t columns, rows;   ///< points along x and y; at least 2
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
  std::uint64_t bitmask = 65535;  ///< as in MARS: two shapes can touch if their masks share a bit
  /// A stand-in that is larger than the shape; it touches the environment only.
  bool is_stand_in = false;
};

struct Plan {
  std::vector<PlacedModel> models;
  std::vector<LinkPlan> links;  ///< by model, in tree order
  std::vector<BodyPlan> bodies;
  std::vector<JointPlan> joints;
  std::vector<ShapePlan> shapes;
  std::size_t unbounded_joints = 0;  ///< joints whose limits cannot be stops
  std::size_t damped_joints = 0;     ///< joints with damping or friction, which are not simulated

  /// "; damping and friction of 6 joints ignored, as MARS does"; "" if there are none.
  std::string text_on_damping() const;

  const LinkedModel& model_of(const LinkPlan& link) const { return *models[link.instance].model; }
  const urdf::Link& link(const LinkPlan& link) const { return model_of(link).link(link.link); }
  const urdf::Joint& joint(const JointPlan& joint) const {
    return models[joint.instance].model->joint(joint.joint);
  }
};

/// Makes bodies and joints; add_shapes() adds shapes. Adds up masses as written, even
/// impossible ones. Precondition: every model has a robot with one root, and bases do not form
/// a cycle.
Plan make_plan(std::vector<PlacedModel> models);

Eigen::Vector3d to_eigen(const Vector3& vector);
Eigen::Vector3d to_world(const Pose& X_WA, const Eigen::Vector3d& p_A);
/// The limits of the URDF (rad or m) that apply to the type of the joint; none if they contradict
/// each other.
std::optional<std::pair<double, double>> limits_of(const urdf::Joint& joint, JointKind kind);
/// Length of the joint's axis as written; 1 if it is absent.
double axis_length(const urdf::Joint& joint);

}  // namespace smurf::load_check
