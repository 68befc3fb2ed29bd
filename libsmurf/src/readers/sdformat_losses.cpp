// SPDX-License-Identifier: BSD-3-Clause
// Sources: sdformat 12.3.0 src/parser_urdf.cc, ReduceFixedJoints, ReduceInertialToParent and
// CreateSDF; 12.7.2 leaves out less.
#include "readers/sdformat_losses.hpp"

#include <algorithm>
#include <cmath>

#include "readers/rigid_bodies.hpp"

namespace smurf {
namespace {

constexpr double kNoMass = 1e-6;  // kg; sdformat compares with 0 within this tolerance

bool is_world(const LinkedModel& model, LinkIndex link) {
  return model.link(link).name.value_or("") == "world";
}

std::optional<LinkIndex> parent_of(const LinkedModel& model, std::size_t link) {
  const auto above = model.tree.parent_joint[link];
  return above ? model.tree.joint_parent[to_size(*above)] : std::nullopt;
}

/// By link: whether sdformat goes on with the links below it.
std::vector<bool> passed_links(const LinkedModel& model, const std::vector<double>& masses) {
  std::vector<bool> passed(masses.size(), false);
  for (const LinkIndex link : model.tree.order) {
    const std::size_t i = to_size(link);
    const auto parent = parent_of(model, i);
    const bool is_reached = !parent || passed[to_size(*parent)];
    passed[i] = is_reached && (is_world(model, link) || std::fabs(masses[i]) > kNoMass);
  }
  return passed;
}

/// Counts links.
class Counter {
 public:
  Counter(const LinkedModel& model, const std::vector<std::size_t>& body)
      : model_(model), body_(body) {}

  /// The links below `top`; only those that are not part of its body if it is merged.
  std::size_t links_below(std::size_t top, bool is_merged) const {
    std::size_t count = 0;
    std::vector<std::size_t> queue{top};
    while (!queue.empty()) {
      const std::size_t link = queue.back();
      queue.pop_back();
      for (const JointIndex below : model_.tree.child_joints[link]) {
        const auto child = model_.tree.joint_child[to_size(below)];
        if (!child || model_.tree.parent_joint[to_size(*child)] != below) continue;
        count += is_merged && body_[to_size(*child)] == body_[top] ? 0 : 1;
        queue.push_back(to_size(*child));
      }
    }
    return count;
  }

 private:
  const LinkedModel& model_;
  const std::vector<std::size_t>& body_;
};

/// By the topmost link of a body: whether urdfdom cannot read the mass of one of its links.
std::vector<bool> unread_bodies(const LinkedModel& model, const std::vector<std::size_t>& body) {
  std::vector<bool> unread(body.size(), false);
  for (std::size_t i = 0; i < body.size(); ++i) {
    const std::optional<urdf::Inertial>& inertial = model.robot->links[i].inertial;
    if (!inertial || !has_exact_name(model, *inertial)) continue;  // SML1501
    if (inertial->mass.value_or(1) != 0 && mass_in_sdformat(model, i) == 0) {
      unread[body[i]] = true;
    }
  }
  return unread;
}

}  // namespace

std::vector<double> merged_masses(const LinkedModel& model) {
  const std::vector<std::size_t> body = bodies_of_sdformat(model);
  std::vector<double> masses(body.size());
  for (std::size_t i = 0; i < body.size(); ++i) masses[i] = mass_in_sdformat(model, i);
  for (std::size_t at = model.tree.order.size(); at-- > 0;) {
    const std::size_t i = to_size(model.tree.order[at]);
    if (body[i] != i) masses[to_size(*parent_of(model, i))] += masses[i];
  }
  return masses;
}

std::vector<LostLimb> limbs_lost_by_sdformat(const LinkedModel& model) {
  std::vector<LostLimb> lost;
  if (!model.robot) return lost;
  const std::vector<std::size_t> body = bodies_of_sdformat(model);
  const std::vector<bool> passed = passed_links(model, merged_masses(model));
  const std::vector<bool> unread = unread_bodies(model, body);
  const Counter counter(model, body);
  for (const LinkIndex link : model.tree.order) {
    const std::size_t i = to_size(link);
    const auto parent = parent_of(model, i);
    if (passed[i] || !parent || !passed[to_size(*parent)]) continue;
    const urdf::Joint& above = model.joint(*model.tree.parent_joint[i]);
    const bool is_fixed = above.type == urdf::JointType::fixed && !is_world(model, *parent);
    if (!is_fixed && unread[i])
      lost.push_back({link, counter.links_below(i, false) + 1, false, true});
    if (!is_fixed) continue;
    const bool is_merged = body[i] != i;
    const std::size_t links = counter.links_below(i, is_merged) + (is_merged ? 0 : 1);
    if (links > 0) lost.push_back({link, links, is_merged});
  }
  return lost;
}

bool InertialsTogether::is_sound(std::size_t link) {
  if (sound_.empty()) sound_ = sound_together(model_);
  return sound_[link];
}

void InertialsTogether::tell(std::size_t link, Diagnostic& diagnostic) {
  if (is_sound(link)) diagnostic.when(kSoundTogether);
  if (left_out_.empty()) {
    const std::vector<std::size_t> body = bodies_of_sdformat(model_);
    const std::vector<bool> passed = passed_links(model_, merged_masses(model_));
    left_out_.resize(body.size());
    // Without its root, the model has no links and is refused.
    const bool has_links = !is_left_without_links(model_);
    for (std::size_t i = 0; i < body.size(); ++i) left_out_[i] = has_links && !passed[body[i]];
  }
  if (left_out_[link]) diagnostic.when(kLeftOut);
}

std::vector<MasslessSum> massless_sums_of_sdformat(const LinkedModel& model) {
  std::vector<MasslessSum> found;
  if (!model.robot) return found;
  struct Sum {
    double mass = 0;
    bool has_inertial = false, is_undefined = false;
  };
  std::vector<Sum> sums(model.robot->links.size());
  bool are_positive = true;  // the sums of such masses are no 0
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = {mass_in_sdformat(model, i), model.robot->links[i].inertial.has_value(), false};
    are_positive = are_positive && (!sums[i].has_inertial || sums[i].mass > 0);
  }
  if (are_positive) return found;
  const std::vector<std::size_t> body = bodies_of_sdformat(model);
  const std::vector<bool> passed = passed_links(model, merged_masses(model));
  std::vector<bool> is_told(body.size(), false);  // by body
  const auto name_of = [&](JointIndex joint) { return model.joint(joint).name.value_or(""); };
  for (std::size_t at = model.tree.order.size(); at-- > 0;) {
    const std::size_t i = to_size(model.tree.order[at]);
    std::vector<JointIndex> joints = model.tree.child_joints[i];
    std::stable_sort(joints.begin(), joints.end(), [&](JointIndex a, JointIndex b) {
      return name_of(a) < name_of(b);  // as urdfdom sorts them
    });
    for (const JointIndex joint : joints) {
      const auto child = model.tree.joint_child[to_size(joint)];
      if (!child || model.tree.parent_joint[to_size(*child)] != joint) continue;
      const Sum& part = sums[to_size(*child)];
      if (body[to_size(*child)] != body[i] || !part.has_inertial) continue;
      const bool is_new = sums[i].mass + part.mass == 0 && !part.is_undefined;
      if (is_new && !is_told[body[i]] && passed[body[i]]) {
        is_told[body[i]] = true;
        found.push_back({*child, model.tree.order[at]});
      }
      sums[i].is_undefined = sums[i].is_undefined || part.is_undefined || is_new;
      sums[i].mass += part.mass;
      sums[i].has_inertial = true;
    }
  }
  return found;
}

}  // namespace smurf
