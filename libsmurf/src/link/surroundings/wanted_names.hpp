// SPDX-License-Identifier: BSD-3-Clause
// What is named at a place of a file around a robot, for editors.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/limits.hpp"
#include "smurf/names.hpp"
#include "smurf/surroundings.hpp"

namespace smurf {

/// Whether a file is one that is read around a robot: a launch file, or one of navigation or RViz.
bool is_surrounding_file(std::string_view path, std::string_view text);

/// The frames that such a file names, whether a robot has them or not.
std::vector<std::string> frames_in(const std::string& path, std::string_view text,
                                   const Limits& limits);

/// The name that is wanted at a place.
struct WantedName {
  std::size_t begin = 0, end = 0;  ///< of the word that is there now
  bool is_yaml = false;            ///< what is written there must be a scalar of YAML
  NameKinds kinds;                 ///< of the robot; empty: an argument of a xacro
  std::string package, file;       ///< this xacro, in the share folder of a package
};
/// None if no name of the robot or argument of its xacro is read there. The text may be unfinished
/// at this place only: the word there is replaced by another one, and the text is read.
std::optional<WantedName> wanted_name(const std::string& path, std::string_view text,
                                      std::size_t offset, const Limits& limits);

/// A text in a launch file that means a file.
struct LaunchLink {
  Span span;
  std::string path;
};
/// The files of packages that are here, and the package.xml of these packages.
std::vector<LaunchLink> launch_links(const LaunchFile& launch, const Surroundings& around);

/// The name of an argument that a launch file gives to the xacro of the robot.
struct LaunchArgument {
  Span span;
  std::string_view name;  ///< points into the launch file
};
std::vector<LaunchArgument> launch_arguments(const LaunchFile& launch);

}  // namespace smurf
