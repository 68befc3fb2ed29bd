// SPDX-License-Identifier: BSD-3-Clause
// Joints that close loops. The tree of a robot stays a tree; these are a list beside it: joints of
// the URDF to a link that has a parent joint already, and joints in `<gazebo>`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "write/parts/scene_parts.hpp"

namespace smurf {

enum class LoopKind : std::uint8_t { fixed, hinge, ball };

struct Loop {
  const urdf::Joint* joint = nullptr;  ///< null for one in `<gazebo>`
  std::string name;
  LoopKind kind = LoopKind::fixed;
  std::size_t parent = 0, child = 0;  ///< links
  Pose X_PJ{}, X_CJ{};                ///< the frame of the joint in both links
  Vector3 axis{1, 0, 0};              ///< of a hinge, in the frame of the joint; of length 1
  Span span;
};

/// The loops of a model whose links have poses, and which are rigid, hinges or balls.
std::vector<Loop> loops_of(const LinkedModel& model);
/// Whether a joint in `<gazebo>` is one of them.
bool is_loop_of_gazebo(const LinkedModel& model, xml::View joint);

/// How far apart both sides of a loop are.
struct LoopGap {
  double distance = 0;  ///< m
  double angle = 0;     ///< rad: between both frames, or both axes of a hinge
  double turn = 0;      ///< rad: of the child about the axis of a hinge
};
LoopGap gap_of(const Loop& loop, const std::vector<std::optional<Pose>>& poses);

/// Whether all joints around a loop turn about parallel axes, so that its links stay in a plane.
bool is_planar(const LinkedModel& model, const Loop& loop,
               const std::vector<std::optional<Pose>>& poses);

}  // namespace smurf
