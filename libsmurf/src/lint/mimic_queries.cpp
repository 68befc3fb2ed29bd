// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mimic_queries.hpp"

#include "lint/drake_queries.hpp"

namespace smurf {

std::optional<std::uint32_t> mimic_leader(const LinkedModel& model, std::uint32_t joint) {
  const std::unique_ptr<urdf::Mimic>& mimic = model.robot->joints[joint].mimic;
  if (!mimic || !mimic->joint) return std::nullopt;
  return model.joint_names.find(*mimic->joint);
}

std::set<std::string_view> followed_joints(const LinkedModel& model) {
  std::set<std::string_view> names;
  if (!model.robot) return names;
  for (const urdf::Joint& joint : model.robot->joints) {
    if (joint.mimic && joint.mimic->joint) names.insert(*joint.mimic->joint);
  }
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View element(model.robot->document, id);
    if (element.name() != "transmission" || !drake::is_simple(element)) continue;
    if (const xml::View joint = element.child("joint"))
      names.insert(drake::value_of(joint, "name"));
  }
  return names;
}

std::vector<bool> endless_mimics(const LinkedModel& model) {
  const auto count = static_cast<std::uint32_t>(model.robot->joints.size());
  std::vector<bool> is_endless(count, false);
  std::vector<std::uint32_t> seen_from(count, count);  // each joint is visited once
  for (std::uint32_t start = 0; start < count; ++start) {
    std::vector<std::uint32_t> walked;
    std::optional<std::uint32_t> at = start;
    while (at && seen_from[*at] == count) {
      seen_from[*at] = start;
      walked.push_back(*at);
      at = mimic_leader(model, *at);
    }
    if (!at || (seen_from[*at] != start && !is_endless[*at])) continue;
    for (const std::uint32_t joint : walked) is_endless[joint] = true;
  }
  return is_endless;
}

}  // namespace smurf
