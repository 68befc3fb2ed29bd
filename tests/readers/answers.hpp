// SPDX-License-Identifier: BSD-3-Clause
// A robot, changes of it, and what a target is said to make of the result.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "smurf/check.hpp"
#include "smurf/verdict.hpp"

namespace smurf {

inline constexpr std::string_view kRobot = R"(<robot name="r">
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
  </inertial>
  <collision><geometry><box size="1 1 1"/></geometry></collision>
</link>
<link name="arm">
  <inertial>
    <mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
  </inertial>
  <collision><geometry><sphere radius="1"/></geometry></collision>
</link>
<joint name="a" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/>
</joint>
</robot>
)";

inline constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// The robot after replacing `original` by `text`; with "", the robot is unchanged.
inline std::string damaged(std::string_view original, std::string_view text) {
  std::string robot(kRobot);
  for (std::size_t at = original.empty() ? std::string::npos : robot.find(original);
       at != std::string::npos; at = robot.find(original, at + text.size())) {
    robot.replace(at, original.size(), text);
  }
  return robot;
}

inline Answer answer_to(std::string_view target, const std::string& robot,
                        std::span<const char* const> meshes = {}) {
  MemoryFiles files;
  files.add("robot.urdf", robot);
  for (const char* path : meshes) files.add(path, kTetrahedron);
  CheckSettings settings;
  settings.selection.targets = {find_target(target)};
  Session session(files);
  const Report report = session.check("robot.urdf", settings);
  REQUIRE(report.targets.size() == 1);
  return report.targets.front().answer();
}

inline Answer answer_for(std::string_view target, std::string_view original,
                         std::string_view text) {
  return answer_to(target, damaged(original, text));
}

/// The robot with more elements at its end.
inline std::string with(std::string_view elements, std::string robot = std::string(kRobot)) {
  return robot.insert(robot.rfind("</robot>"), elements);
}

inline constexpr std::string_view kTip =
    "<link name=\"tip\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" "
    "iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>";
inline constexpr std::string_view kFrame = "<link name=\"tip\"/>";

inline std::string joint(std::string_view name, std::string_view type, std::string_view parent,
                         std::string_view child, std::string_view rest = "") {
  std::string text("<joint name=\"");
  text.append(name).append("\" type=\"").append(type).append("\"><parent link=\"");
  text.append(parent).append("\"/><child link=\"").append(child).append("\"/>");
  return text.append(rest).append("</joint>");
}

}  // namespace smurf
