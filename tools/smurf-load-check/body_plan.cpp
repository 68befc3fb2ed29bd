// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/body_plan.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/text/counted.hpp"
#include "link/kinematics.hpp"

namespace smurf::load_check {
namespace {

/// ODE wraps the angle of a hinge to (-pi, pi], so a stop beyond has no effect.
bool is_within_turn(const std::pair<double, double>& stops, double start) {
  return stops.first - start >= -std::numbers::pi && stops.second - start <= std::numbers::pi;
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
  /// Models after the models that carry them.
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
    forms_ = joint_forms(model);
    body_of_[instance].resize(model.robot->links.size(), kWorld);
    for (const LinkIndex link : model.tree.order) {
      if (!X_RL[to_size(link)]) continue;
      const Pose X_WL = placed.X_WR * *X_RL[to_size(link)];
      const auto above = model.tree.parent_joint[to_size(link)];
      std::size_t body = above ? body_below(instance, *above) : base_body(placed.base);
      if (body == kNew) {
        body = plan_.bodies.size();
        plan_.bodies.push_back(
            {.first_link = plan_.links.size(), .mass = {}, .is_stand_in = false});
      }
      body_of_[instance][to_size(link)] = body;
      plan_.links.push_back({instance, link, body, X_WL});
      if (body != kWorld) add_mass(plan_.bodies[body], model.link(link), X_WL);
      if (above && forms_[to_size(*above)]) add_joint(instance, *above, X_WL);
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
    if (forms_[to_size(joint)]) return kNew;
    return body_of_[instance][to_size(*model.tree.joint_parent[to_size(joint)])];
  }

  void add_joint(std::size_t instance, JointIndex index, const Pose& X_WC) {
    const LinkedModel& model = *plan_.models[instance].model;
    const urdf::Joint& joint = model.joint(index);
    const JointForm& form = *forms_[to_size(index)];
    const auto to_world_axis = [&](const Eigen::Vector3d& axis) {
      return to_eigen(rotate(X_WC.orientation, {axis[0], axis[1], axis[2]}));
    };
    JointPlan plan;
    plan.kind = form.kind;
    plan.form_place = form.place;
    plan.instance = instance;
    plan.joint = index;
    plan.parent = body_of_[instance][to_size(*model.tree.joint_parent[to_size(index)])];
    plan.child = body_of_[instance][to_size(*model.tree.joint_child[to_size(index)])];
    plan.anchor_W = to_eigen(X_WC.position);
    // A joint does not move its axis, so the child's frame can be used.
    plan.axis_W = to_world_axis(form.axis_C);
    plan.axis2_W = to_world_axis(form.axis2_C);
    if (joint.has_one_axis()) {
      plan.start = position_of(model, joint, plan_.models[instance].positions);
    }
    plan.limits = plan.stops = limits_of(joint, form.kind);
    if (plan.stops && form.kind == JointKind::hinge && !is_within_turn(*plan.stops, plan.start)) {
      plan.stops.reset();
      ++plan_.unbounded_joints;
    }
    if (joint.dynamics &&
        (joint.dynamics->damping.value_or(0) != 0 || joint.dynamics->friction.value_or(0) != 0)) {
      ++plan_.damped_joints;
    }
    plan_.joints.push_back(std::move(plan));
  }

  static constexpr std::size_t kNew = kWorld - 2;
  Plan plan_;
  std::vector<std::optional<JointForm>> forms_;    ///< of the model that is being added
  std::vector<std::vector<std::size_t>> body_of_;  ///< by instance and link
};

}  // namespace

Plan make_plan(std::vector<PlacedModel> models) { return Planner(std::move(models)).run(); }

Eigen::Vector3d to_eigen(const Vector3& vector) { return {vector[0], vector[1], vector[2]}; }

Eigen::Vector3d to_world(const Pose& X_WA, const Eigen::Vector3d& p_A) {
  return to_eigen(X_WA.position) + to_eigen(rotate(X_WA.orientation, {p_A[0], p_A[1], p_A[2]}));
}

std::optional<std::pair<double, double>> limits_of(const urdf::Joint& joint, JointKind kind) {
  const bool is_limited = (joint.type == urdf::JointType::revolute && kind == JointKind::hinge) ||
                          (joint.type == urdf::JointType::prismatic && kind == JointKind::slider);
  if (!joint.limit || !is_limited) return std::nullopt;
  const std::pair limits{joint.limit->lower.value_or(0), joint.limit->upper.value_or(0)};
  if (limits.first > limits.second) return std::nullopt;
  return limits;
}

double axis_length(const urdf::Joint& joint) {
  return joint.axis ? std::hypot((*joint.axis)[0], (*joint.axis)[1], (*joint.axis)[2]) : 1;
}

std::string Plan::text_on_damping() const {
  if (damped_joints == 0) return {};
  return "; damping and friction of " + counted(damped_joints, "joint") + " ignored, as MARS does";
}

}  // namespace smurf::load_check
