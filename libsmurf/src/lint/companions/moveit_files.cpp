// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/moveit_files.hpp"

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

}  // namespace

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
