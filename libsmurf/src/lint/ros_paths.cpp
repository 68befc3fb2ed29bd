// SPDX-License-Identifier: BSD-3-Clause
#include "lint/ros_paths.hpp"

#include <set>

#include "base/text/edits.hpp"

namespace smurf {

bool is_lost_to_ros(const MeshReference& reference) {
  return reference.exists && path_fault(reference) == PathFault::none &&
         reference.filename.find("://") == std::string::npos;
}

Diagnostic* report_lost_to_ros(const LinkedModel& model, bool in_package, Findings& findings) {
  Habit habit;
  const MeshReference* first = nullptr;
  Fix fix;
  for (const MeshReference& reference : model.meshes) {
    if (!is_lost_to_ros(reference) || reference.meant.empty() == in_package) continue;
    if (first == nullptr) first = &reference;
    habit.add(reference.span, "ROS looks for " + quoted(reference.filename) +
                                  " without the folder of the URDF, and does not find it");
    if (in_package) {
      fix.edits.push_back({reference.span, escape_xml(reference.meant)});
    }
  }
  Diagnostic* diagnostic = habit.report("such paths", findings);
  if (diagnostic == nullptr) return nullptr;
  if (in_package) {
    diagnostic->help("write " + quoted(first->meant));
    diagnostic->fixes.push_back(std::move(fix));
  } else {
    diagnostic->help("write `package://NAME/PATH`, with the name in the package.xml of a package");
  }
  return diagnostic;
}

}  // namespace smurf
