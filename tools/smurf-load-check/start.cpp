// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/start.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "link/kinematics.hpp"

namespace smurf::load_check {
namespace {

using Interval = std::pair<double, double>;

/// The joint that moves this one: itself unless it mimics another joint. None for cycles.
const urdf::Joint* leader_of(const LinkedModel& model, const urdf::Joint& joint) {
  constexpr int kLongestChain = 64;  // as in position_of()
  const urdf::Joint* current = &joint;
  for (int step = 0; step < kLongestChain; ++step) {
    if (!current->mimic || !current->mimic->joint) return current;
    const auto next = model.joint_names.find(*current->mimic->joint);
    if (!next) return current;
    current = &model.robot->joints[*next];
  }
  return nullptr;
}

/// The positions of the leader at which this joint is within its limits.
std::optional<Interval> seen_from_leader(const LinkedModel& model, const urdf::Joint& joint,
                                         const std::string& leader, const Interval& limits) {
  const double offset = position_of(model, joint, {{leader, 0}});
  const double factor = position_of(model, joint, {{leader, 1}}) - offset;
  if (factor == 0) return std::nullopt;
  const double first = (limits.first - offset) / factor;
  const double second = (limits.second - offset) / factor;
  return std::minmax(first, second);
}

}  // namespace

JointPositions start_positions(const LinkedModel& model, const JointPositions& given) {
  const std::vector<std::optional<JointForm>> forms = joint_forms(model);
  std::map<std::string, Interval, std::less<>> allowed;  // by leader
  // Leaders first: what their own limits forbid, no joint that mimics them may ask for.
  for (const bool is_leading : {true, false}) {
    for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
      const urdf::Joint& joint = model.robot->joints[i];
      const auto limits = forms[i] ? limits_of(joint, forms[i]->kind) : std::nullopt;
      const urdf::Joint* leader = leader_of(model, joint);
      if (!limits || leader == nullptr || !leader->name) continue;
      if (is_leading != (leader == &joint)) continue;
      const auto seen =
          is_leading ? limits : seen_from_leader(model, joint, *leader->name, *limits);
      if (!seen) continue;
      const auto [entry, is_new] = allowed.try_emplace(*leader->name, *seen);
      const Interval both{std::max(entry->second.first, seen->first),
                          std::min(entry->second.second, seen->second)};
      if (both.first <= both.second) entry->second = both;
    }
  }
  JointPositions positions = given;
  for (const auto& [leader, interval] : allowed) {
    const double nearest = std::clamp(0.0, interval.first, interval.second);
    if (nearest != 0) positions.try_emplace(leader, nearest);
  }
  return positions;
}

double outside_limits(const JointPlan& joint) {
  // The position of a joint that mimics another one has a rounding error.
  constexpr double kRounding = 1e-12;  // rad or m
  if (!joint.limits) return 0;
  const double outside =
      std::max(joint.limits->first - joint.start, joint.start - joint.limits->second);
  return outside > kRounding ? outside : 0;
}

const JointPlan* joint_at_stop(const Plan& plan) {
  constexpr double kNear = 1e-6;  // rad or m
  for (const JointPlan& joint : plan.joints) {
    if (!joint.stops) continue;
    const double room =
        std::min(joint.start - joint.stops->first, joint.stops->second - joint.start);
    if (std::fabs(room) <= kNear) return &joint;
  }
  return nullptr;
}

}  // namespace smurf::load_check
