// SPDX-License-Identifier: BSD-3-Clause
// Coordinate frames that files of ROS name: links of the robot, or frames that other nodes publish.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lint/queries.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// The only known name of two or more words that differs in the last one: `camera_optical_link` for
/// `camera_optical_frame`.
std::optional<std::string_view> like_name(std::string_view name,
                                          std::span<const std::string_view> known);

/// Whether a frame is one of the world, which no robot has: `odom`, `map`.
bool is_world_frame(std::string_view frame);

/// SML3713, SML4501: the frame is similar to a link.
inline constexpr Circumstance kMisspeltFrame{"misspelt"};
/// The frame begins with a slash.
inline constexpr Circumstance kSlashedFrame{"slash"};

/// Reports a frame that should be a link of the robot and is not: "`subject` names the frame `x`,
/// ...". One without a similar link is an info: other nodes may publish it. Returns null if the
/// frame is a link, a frame of the world, or filled in later.
Diagnostic* check_frame(const LinkedModel& model, std::string_view frame, Span place,
                        const std::string& subject, Findings& findings);

/// The name of the root link; empty if there are several, or none.
std::string_view root_link(const LinkedModel& model);

}  // namespace smurf
