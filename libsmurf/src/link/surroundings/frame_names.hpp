// SPDX-License-Identifier: BSD-3-Clause
// Where files around a robot name its frames. Rules, hover, jumps, completion and renaming ask
// here, and keep no lists of their own.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "link/reference_finder.hpp"
#include "smurf/surroundings.hpp"

namespace smurf {

/// A text that may name a part of the robot.
struct FrameName {
  enum class Use : std::uint8_t {
    robot,    ///< its reader needs a link of the robot: `robot_base_frame`
    sensor,   ///< a link, or the frame of a driver: `sensor_frame`, `Fixed Frame`
    outside,  ///< a frame around the robot: `odom_frame`
    parent,   ///< of a static transform
    child,    ///< of a static transform
    other,    ///< a link, if it is called like one
    memory,   ///< what RViz remembers about a link; it ignores links that it does not know
  };
  Use use{};
  NameKinds kinds = NameKind::link;
  std::string_view name;  ///< as written; it may begin with a slash
  NamePlace place;
  Span written;           ///< the whole value
  std::string_view key;   ///< the parameter
  std::string_view node;  ///< around it; "": unknown
};
using TakeFrame = std::function<void(const FrameName&)>;

/// A form of files that name frames. To add one: an enumerator of FrameFile::Form, a file with its
/// two functions, and a row in frame_names.cpp.
struct FrameForm {
  FrameFile::Form form{};
  std::string_view extensions;  ///< ".yaml .yml"
  bool is_yaml = false;
  bool (*is_one)(std::string_view text) = nullptr;
  void (*visit)(const FrameFile& file, const TakeFrame& take) = nullptr;
};
/// The form of a file with this name; null if it has none.
const FrameForm* find_frame_form(std::string_view path);

/// Every text in a file that may name a frame, from its beginning to its end.
void for_each_frame(const FrameFile& file, const TakeFrame& take);
/// The same in a launch file, where values are written as they are.
void for_each_frame(const LaunchFile& file, const TakeFrame& take);

/// A static transform between two frames.
struct StaticTransform {
  const LaunchNode* node = nullptr;
  const LaunchText* parent = nullptr;  ///< null if they are not written
  const LaunchText* child = nullptr;
};
/// None if a node is not known to publish one.
std::optional<StaticTransform> static_transform_of(const LaunchNode& node);

/// Parameters that often have the name of a link: `base_frame_id`, `chain_tip`, `robot_base_link`.
bool may_hold_link(std::string_view key);

// frames_in_parameters.cpp
bool is_frame_parameters(std::string_view text);
void visit_parameters(const FrameFile& file, const TakeFrame& take);
// frames_in_rviz.cpp
bool is_rviz(std::string_view text);
void visit_rviz(const FrameFile& file, const TakeFrame& take);
// frames_in_lua.cpp
bool is_cartographer(std::string_view text);
void visit_lua(const FrameFile& file, const TakeFrame& take);

}  // namespace smurf
