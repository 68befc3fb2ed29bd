// SPDX-License-Identifier: BSD-3-Clause
#include "lint/ros_paths.hpp"

#include "base/text/edits.hpp"

namespace smurf {

bool is_lost_to_ros(const MeshReference& reference) {
  return reference.exists && path_fault(reference) == PathFault::none &&
         reference.filename.find("://") == std::string::npos;
}

void report_lost_to_ros(const LinkedModel& model, bool in_package, Findings& findings) {
  for (const MeshReference& reference : model.meshes) {
    if (!is_lost_to_ros(reference) || reference.meant.empty() == in_package) continue;
    Diagnostic& finding =
        findings.report_habit(reference.span,
                              "ROS looks for " + quoted(reference.filename) +
                                  " without the folder of the URDF, and does not find it",
                              "such paths");
    if (in_package) {
      finding.help("write " + quoted(reference.meant));
      finding.fixes.push_back(
          {Applicability::unsafe, {{reference.span, escape_xml(reference.meant)}}});
    } else {
      finding.help("write `package://NAME/PATH`, with the name in the package.xml of a package");
    }
  }
}

}  // namespace smurf
