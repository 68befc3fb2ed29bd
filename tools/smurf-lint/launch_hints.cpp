// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/launch_hints.hpp"

#include <algorithm>
#include <string_view>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "plan/xacro_text.hpp"
#include "smurf/file_reader.hpp"
#include "xacro/seen_arguments.hpp"

namespace smurf::tools {
namespace {

constexpr std::size_t kMostFiles = 2000;
constexpr std::uint64_t kMostOfLaunch = 1U << 20U;

bool is_launch_file(std::string_view name) {
  return name.ends_with(".launch.py") || name.ends_with(".launch") || name.ends_with(".launch.xml");
}

void find_launch_files(const std::string& folder, int depth, std::vector<std::string>& found) {
  constexpr int kDeepest = 12;
  if (depth > kDeepest) return;
  std::vector<std::string> below;
  places::for_each_entry(folder, [&](const std::string& name, places::Entry kind) {
    if (name.starts_with('.') || found.size() >= kMostFiles) return true;
    if (kind == places::Entry::folder) below.push_back(name);
    if (is_launch_file(name)) found.push_back(path::join(folder, name));
    return true;
  });
  std::sort(below.begin(), below.end());
  for (const std::string& name : below) {
    find_launch_files(path::join(folder, name), depth + 1, found);
  }
}

/// Values that an argument needs from outside. `is_open`: it has none of its own where it is used.
std::vector<std::string> values_of(std::string_view launch, const XacroName& argument,
                                   bool is_open) {
  std::vector<std::string> values = xacro::values_in(launch, argument.name);
  if (is_open) return values;
  // The own default is as good as what a launch file says, unless it is not one of the choices.
  const bool is_choice = values.size() > 1;
  const bool has_default = argument.has_value && !argument.value.empty();
  if (has_default && !is_choice) return {};
  const bool is_known = std::find(values.begin(), values.end(), argument.value) != values.end();
  const bool is_computed = argument.value.find('$') != std::string::npos;
  if (has_default && (is_known || is_computed)) return {};
  return values;
}

}  // namespace

std::vector<LaunchedRobot> launched_robots(const std::string& folder,
                                           const std::vector<std::string>& robots,
                                           const Limits& limits) {
  const DiskFiles disk;
  std::vector<std::string> launches;
  find_launch_files(folder, 0, launches);
  std::vector<std::string> texts;
  for (const std::string& path : launches) texts.push_back(disk.read(path, kMostOfLaunch).text);
  std::vector<LaunchedRobot> found;
  for (const std::string& robot : robots) {
    const std::string_view name = path::file_name(robot);
    LaunchedRobot one{robot, {}};
    const std::string own = disk.read(robot, limits.file_bytes).text;
    // Those that are used above their definition, or have none, need a value from outside.
    std::vector<std::string> open = xacro::undeclared_arguments(own);
    std::vector<XacroName> arguments = read_xacro_text(own).names;
    std::erase_if(arguments, [](const XacroName& argument) {
      return argument.kind != XacroNameKind::argument;
    });
    for (const std::string& name_of_open : open) {
      const bool is_known =
          std::any_of(arguments.begin(), arguments.end(),
                      [&](const XacroName& argument) { return argument.name == name_of_open; });
      if (is_known) continue;
      arguments.emplace_back().name = name_of_open;
    }
    for (const XacroName& argument : arguments) {
      const bool is_open = std::find(open.begin(), open.end(), argument.name) != open.end();
      std::vector<std::string> values;
      for (std::size_t i = 0; i < texts.size() && values.empty(); ++i) {
        if (texts[i].find(name) == std::string::npos) continue;
        values = values_of(texts[i], argument, is_open);
      }
      if (values.empty() && is_open) {  // what a check uses
        const auto seen = xacro::seen_arguments(robot, {argument.name}, disk);
        if (!seen.empty()) values.push_back(seen.front().value);
      }
      if (!values.empty()) one.arguments.emplace_back(argument.name, std::move(values));
    }
    if (!one.arguments.empty()) found.push_back(std::move(one));
  }
  return found;
}

}  // namespace smurf::tools
