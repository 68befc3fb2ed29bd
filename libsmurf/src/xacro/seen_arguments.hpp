// SPDX-License-Identifier: BSD-3-Clause
// The values that the launch files of a package give to arguments of its xacro files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"

namespace smurf::xacro {

struct SeenArgument {
  std::string name, value;
  std::string file;
};

/// Literal values of these arguments in the launch files (XML and Python) and CMakeLists.txt of the
/// package around a file; the first of each argument and value. `root` is the path of the file.
std::vector<SeenArgument> seen_arguments(const std::string& root,
                                         const std::vector<std::string>& names,
                                         const FileReader& files);

/// The literal values that the text of one such file gives to an argument: the choices of a launch
/// argument of this name; else `name:=value`, members of mappings and defaults, each once. This is
/// the only reader of values in launch files.
std::vector<std::string> values_in(std::string_view text, std::string_view name);

/// The choices of a launch argument of this name; empty if it may have any value.
std::vector<std::string> choices_in(std::string_view text, std::string_view name);

/// The names of all arguments that a text declares or uses.
std::vector<std::string> all_arguments(std::string_view text);

/// The names in `$(arg NAME)` of a text that no `<xacro:arg>` above them declares.
std::vector<std::string> undeclared_arguments(std::string_view text);

}  // namespace smurf::xacro
