// SPDX-License-Identifier: BSD-3-Clause
// Describes what the files of ROS beside a robot may contain, for people who write one. Made from
// the tables that the rules use.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/key_help.hpp"

namespace smurf {

/// A parameter file of ROS, or an SRDF.
struct CompanionLanguage {
  std::string_view title;  ///< "controllers.yaml", as in the table of kinds; "SRDF"
  std::string_view text;   ///< of the file, which says the types of its controllers
};

/// The keys that the mapping at a path may have.
std::vector<KeyHelp> companion_keys_in(const CompanionLanguage& language,
                                       std::span<const std::string> path);
/// The last key of a path; none if no table has it.
std::optional<KeyHelp> companion_key_help(const CompanionLanguage& language,
                                          std::span<const std::string> path);
/// The kinds of things that the keys of the mapping at a path name.
NameKinds companion_names_in(const CompanionLanguage& language, std::span<const std::string> path);

/// An element of an SRDF or within `ros2_control`; `parent` is "" for the root of an SRDF.
std::optional<ElementHelp> companion_element_help(std::string_view parent, std::string_view name);

}  // namespace smurf
