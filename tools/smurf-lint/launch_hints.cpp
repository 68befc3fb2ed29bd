// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/launch_hints.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "plan/launched_values.hpp"
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

/// The choices of an argument; empty if its own default is one of them.
std::vector<std::string> choices_of(std::string_view launch, const XacroName& argument) {
  std::vector<std::string> choices = xacro::choices_in(launch, argument.name);
  const bool is_one = std::find(choices.begin(), choices.end(), argument.value) != choices.end();
  const bool is_computed = argument.value.find('$') != std::string::npos;
  return is_one || is_computed ? std::vector<std::string>() : choices;
}

/// What the launch files say about one robot; no arguments if that is of no use.
LaunchedRobot launched(const std::string& robot, const std::vector<std::string>& launches,
                       const FileReader& files, const Limits& limits) {
  LaunchedRobot one{robot, {}};
  std::map<std::string, std::string> arguments;
  const std::string_view name = path::file_name(robot);
  for (const XacroName& argument :
       read_xacro_text(files.read(robot, limits.file_bytes).text).names) {
    if (argument.kind != XacroNameKind::argument) continue;
    std::vector<std::string> choices;
    for (std::size_t i = 0; i < launches.size() && choices.empty(); ++i) {
      if (launches[i].find(name) != std::string::npos) choices = choices_of(launches[i], argument);
    }
    if (choices.empty()) continue;
    arguments.emplace(argument.name, choices.front());
    one.arguments.emplace_back(argument.name, std::move(choices));
  }
  for (const xacro::SeenArgument& value : launched_values(robot, arguments, files, limits)) {
    one.arguments.emplace_back(value.name, std::vector<std::string>{value.value});
    arguments.emplace(value.name, value.value);
  }
  std::sort(one.arguments.begin(), one.arguments.end());
  if (!one.arguments.empty() && !is_expandable(robot, arguments, files, limits))
    one.arguments.clear();
  return one;
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
    LaunchedRobot one = launched(robot, texts, disk, limits);
    if (!one.arguments.empty()) found.push_back(std::move(one));
  }
  return found;
}

}  // namespace smurf::tools
