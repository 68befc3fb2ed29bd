// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/moveit_files.hpp"

#include <vector>

#include "base/text/words.hpp"

namespace smurf {
namespace {

void visit_limits(const Companion& file, yaml::View root,
                  const std::function<void(const Companion&, yaml::View)>& visit) {
  for (const yaml::View member : root) {
    if (!member.is_mapping() || member.is_repeated()) continue;
    if (member.key() == "robot_description_planning") {
      visit_limits(file, member, visit);
    } else if (member.key() == "joint_limits") {
      for (const yaml::View joint : member) {
        if (joint.is_mapping() && !joint.is_repeated()) visit(file, joint);
      }
    }
  }
}

using Visit =
    std::function<void(const Companion&, const RosParameter&, yaml::View, const std::string&)>;

/// Whether a limit of a joint counts.
bool is_read(yaml::View joint, std::string_view key) {
  const std::size_t underscore = key.find('_');
  const bool is_limit = key.starts_with("max_") || key.starts_with("min_");
  if (!is_limit || key.ends_with("_position")) return true;
  const yaml::View has = joint.find("has" + std::string(key.substr(underscore)) + "_limits");
  return has && has.is_scalar() && has.boolean() == true;
}

void visit_values(const Companion& file, const std::vector<RosParameter>& known, yaml::View mapping,
                  const std::string& prefix, const Visit& visit) {
  for (const yaml::View member : mapping) {
    if (member.is_repeated()) continue;
    if (prefix.empty() && member.is_mapping() && is_moveit_wrapper(member.key())) {
      visit_values(file, known, member, prefix, visit);
      continue;
    }
    const std::string path = prefix + std::string(member.key());
    if (const RosParameter* one = find_parameter(known, path)) {
      const bool is_limit = one->path.starts_with("joint_limits.");
      if (!is_limit || is_read(mapping, member.key())) visit(file, *one, member, path);
    } else if (member.is_mapping()) {
      visit_values(file, known, member, path + ".", visit);
    }
  }
}

}  // namespace

bool is_moveit_wrapper(std::string_view key) {
  return is_one_of(key, {"robot_description_planning", "robot_description_kinematics",
                         "ros__parameters", "/**", "move_group"});
}

void for_each_moveit_value(const Companions& companions, const Visit& visit) {
  for (const Companion& file : companions.files) {
    const MoveitFile* kind = find_moveit_file(spec_of(file.kind).title);
    if (kind == nullptr || !file.document) continue;
    const yaml::View root = file.document->view();
    if (root && root.is_mapping()) visit_values(file, parameters_of(*kind), root, "", visit);
  }
}

const Companion* only_srdf(const Companions& companions) {
  const Companion* only = nullptr;
  for (const Companion& file : companions.files) {
    if (!file.srdf) continue;
    if (only != nullptr) return nullptr;
    only = &file;
  }
  return only;
}

void for_each_file(const Companions& companions, CompanionKind kind,
                   const std::function<void(const Companion&, yaml::View)>& visit) {
  for (const Companion& one : companions.files) {
    if (one.kind != kind || !one.document) continue;
    const yaml::View root = one.document->view();
    if (root && root.is_mapping()) visit(one, root);
  }
}

void for_each_joint_limit(const Companions& companions,
                          const std::function<void(const Companion&, yaml::View)>& visit) {
  for_each_file(companions, CompanionKind::joint_limits,
                [&](const Companion& file, yaml::View root) { visit_limits(file, root, visit); });
}

}  // namespace smurf
