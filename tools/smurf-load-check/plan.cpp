// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/plan.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace smurf::load_check {
namespace {

/// ODE wraps the angle of a hinge to (-pi, pi]; a stop beyond has no meaning there.
std::optional<std::pair<double, double>> stops_of(const urdf::Joint& joint, double start) {
  if (!joint.limit || joint.type == urdf::JointType::continuous || !joint.has_one_axis()) {
    return std::nullopt;
  }
  const std::pair stops{joint.limit->lower.value_or(0), joint.limit->upper.value_or(0)};
  if (stops.first > stops.second) return std::nullopt;
  const bool is_within_turn =
      stops.first - start >= -std::numbers::pi && stops.second - start <= std::numbers::pi;
  if (joint.type == urdf::JointType::revolute && !is_within_turn) return std::nullopt;
  return stops;
}

JointPlan::Kind kind_of(urdf::JointType type) {
  switch (type) {
  case urdf::JointType::prismatic: return JointPlan::Kind::slider;
  case urdf::JointType::planar:
  case urdf::JointType::floating: return JointPlan::Kind::free;
  default: return JointPlan::Kind::hinge;
  }
}

class Planner {
 public:
  explicit Planner(std::vector<PlacedModel> models) { plan_.models = std::move(models); }

  Plan run() {
    body_of_.resize(plan_.models.size());
    for (const std::size_t instance : bases_first()) add_model(instance);
    return std::move(plan_);
  }

 private:
  /// Models after those they stand on.
  std::vector<std::size_t> bases_first() const {
    std::vector<std::vector<std::size_t>> above(plan_.models.size());
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < plan_.models.size(); ++i) {
      const Base& base = plan_.models[i].base;
      (base.kind == Base::Kind::link ? above[base.instance] : order).push_back(i);
    }
    for (std::size_t at = 0; at < order.size(); ++at) {
      const std::vector<std::size_t>& next = above[order[at]];
      order.insert(order.end(), next.begin(), next.end());
    }
    return order;
  }

  void add_model(std::size_t instance) {
    const PlacedModel& placed = plan_.models[instance];
    const LinkedModel& model = *placed.model;
    const std::vector<std::optional<Pose>> X_RL = forward_kinematics(model, placed.positions);
    body_of_[instance].resize(model.robot->links.size(), kWorld);
    for (const LinkIndex link : model.tree.order) {
      if (!X_RL[to_size(link)]) continue;
      const Pose X_WL = placed.X_WR * *X_RL[to_size(link)];
      const auto above = model.tree.parent_joint[to_size(link)];
      std::size_t body = above ? body_below(instance, *above) : base_body(placed.base);
      if (body == kNew) {
        body = plan_.bodies.size();
        plan_.bodies.push_back({.first_link = plan_.links.size(), .mass = {}});
      }
      body_of_[instance][to_size(link)] = body;
      plan_.links.push_back({instance, link, body, X_WL});
      if (body != kWorld) add_mass(plan_.bodies[body], model.link(link), X_WL);
      if (above && model.joint(*above).is_movable()) add_joint(instance, *above, X_WL);
    }
  }

  static void add_mass(BodyPlan& body, const urdf::Link& link, const Pose& X_WL) {
    body.mass = combined(body.mass, transformed(mass_properties(link), X_WL));
  }

  std::size_t base_body(const Base& base) const {
    switch (base.kind) {
    case Base::Kind::world: return kWorld;
    case Base::Kind::link: return body_of_[base.instance][to_size(base.link)];
    case Base::Kind::free: break;
    }
    return kNew;
  }

  std::size_t body_below(std::size_t instance, JointIndex joint) const {
    const LinkedModel& model = *plan_.models[instance].model;
    if (model.joint(joint).is_movable()) return kNew;
    return body_of_[instance][to_size(*model.tree.joint_parent[to_size(joint)])];
  }

  void add_joint(std::size_t instance, JointIndex index, const Pose& X_WC) {
    const LinkedModel& model = *plan_.models[instance].model;
    const urdf::Joint& joint = model.joint(index);
    JointPlan plan;
    plan.kind = kind_of(joint.type);
    plan.instance = instance;
    plan.joint = index;
    plan.parent = body_of_[instance][to_size(*model.tree.joint_parent[to_size(index)])];
    plan.child = body_of_[instance][to_size(*model.tree.joint_child[to_size(index)])];
    plan.anchor_W = to_eigen(X_WC.position);
    // The motion of a joint leaves its axis where it is, so that the child's frame will do.
    const Eigen::Vector3d axis = to_eigen(joint.axis.value_or(Vector3{1, 0, 0})).normalized();
    plan.axis_W = to_eigen(rotate(X_WC.orientation, {axis[0], axis[1], axis[2]}));
    if (joint.name) {
      const auto given = plan_.models[instance].positions.find(*joint.name);
      if (given != plan_.models[instance].positions.end()) plan.start = given->second;
    }
    // Where a mimicking joint stands is its leader's business, so that its stops are unknown.
    const bool has_start = !joint.mimic || plan_.models[instance].positions.empty();
    if (has_start) plan.stops = stops_of(joint, plan.start);
    if (joint.type == urdf::JointType::revolute && joint.limit && has_start && !plan.stops) {
      ++plan_.unbounded_joints;
    }
    if (joint.type == urdf::JointType::planar) ++plan_.planar_joints;
    plan_.joints.push_back(std::move(plan));
  }

  static constexpr std::size_t kNew = kWorld - 2;
  Plan plan_;
  std::vector<std::vector<std::size_t>> body_of_;  ///< by instance and link
};

}  // namespace

Plan make_plan(std::vector<PlacedModel> models) { return Planner(std::move(models)).run(); }

Eigen::Vector3d to_eigen(const Vector3& vector) { return {vector[0], vector[1], vector[2]}; }

Eigen::Vector3d to_world(const Pose& X_WA, const Eigen::Vector3d& p_A) {
  return to_eigen(X_WA.position) + to_eigen(rotate(X_WA.orientation, {p_A[0], p_A[1], p_A[2]}));
}

double axis_length(const urdf::Joint& joint) {
  return joint.axis ? std::hypot((*joint.axis)[0], (*joint.axis)[1], (*joint.axis)[2]) : 1;
}

}  // namespace smurf::load_check
