// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/launch_hints.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/xacro_text.hpp"

namespace smurf::tools {
namespace {

constexpr std::size_t kMostFiles = 2000;
constexpr std::size_t kMostValues = 50;
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

bool is_plain(std::string_view value) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  return !value.empty() && value.find_first_not_of(kPlain) == std::string_view::npos;
}

/// The texts in quotes in a text.
std::vector<std::string> quoted_in(std::string_view text) {
  std::vector<std::string> found;
  for (std::size_t at = text.find_first_of("'\""); at != std::string_view::npos;
       at = text.find_first_of("'\"", at)) {
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string_view::npos || found.size() >= kMostValues) break;
    if (is_plain(text.substr(at + 1, end - at - 1))) {
      found.emplace_back(text.substr(at + 1, end - at - 1));
    }
    at = end + 1;
  }
  return found;
}

/// What `DeclareLaunchArgument("name", ..., choices=[...])` or its default says.
std::vector<std::string> declared_in_python(std::string_view text, std::string_view name) {
  constexpr std::string_view kDeclare = "DeclareLaunchArgument(";
  for (std::size_t at = text.find(kDeclare); at != std::string_view::npos;
       at = text.find(kDeclare, at + 1)) {
    std::string_view call = text.substr(at + kDeclare.size());
    call = call.substr(0, call.find(kDeclare));
    std::string_view first = call.substr(std::min(call.find_first_not_of(" \t\r\n"), call.size()));
    if (first.starts_with("name=")) first.remove_prefix(5);
    if (first.size() < name.size() + 2 || first.substr(1, name.size()) != name) continue;
    if (first[0] != first[name.size() + 1] || (first[0] != '"' && first[0] != '\'')) continue;
    if (const std::size_t choices = call.find("choices=["); choices != std::string_view::npos) {
      const std::string_view list = call.substr(choices + 9);
      return quoted_in(list.substr(0, list.find(']')));
    }
    const std::size_t usual = call.find("default_value=");
    if (usual == std::string_view::npos) continue;
    const std::string_view value = call.substr(usual + 14);
    if (!value.starts_with('"') && !value.starts_with('\'')) continue;
    return quoted_in(value.substr(0, value.find(value[0], 1) + 1));
  }
  return {};
}

/// What `name:=value` says.
std::vector<std::string> given_in(std::string_view text, std::string_view name) {
  const std::string wanted = std::string(name) + ":=";
  for (std::size_t at = text.find(wanted); at != std::string_view::npos;
       at = text.find(wanted, at + 1)) {
    std::string_view rest = text.substr(at + wanted.size());
    // "name:=", "value"
    if (rest.starts_with('"') || rest.starts_with('\'')) {
      const std::size_t next = rest.find_first_not_of(" ,\t\r\n", 1);
      const bool is_text = next != std::string_view::npos && rest[next] == rest[0];
      if (!is_text) continue;
      rest = rest.substr(next + 1);
    }
    const std::string_view value = rest.substr(0, rest.find_first_of("\"' ,)<>\n"));
    if (is_plain(value)) return {std::string(value)};
  }
  return {};
}

/// `robot` is the text of the xacro file.
std::vector<std::string> values_of(std::string_view launch, std::string_view robot,
                                   const XacroName& argument) {
  std::vector<std::string> values = declared_in_python(launch, argument.name);
  if (values.empty()) values = given_in(launch, argument.name);
  // The own default is as good as what a launch file says, unless it is not one of the choices.
  const bool is_choice = values.size() > 1;
  // A use above the definition, such as in the tag of `robot`, needs a value from outside.
  const bool is_used_before =
      robot.substr(0, argument.place.begin).find("$(arg " + argument.name + ")") !=
      std::string_view::npos;
  const bool has_default = argument.has_value && !argument.value.empty() && !is_used_before;
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
    for (const XacroName& argument : read_xacro_text(own).names) {
      if (argument.kind != XacroNameKind::argument) continue;
      for (const std::string& text : texts) {
        if (text.find(name) == std::string::npos) continue;
        std::vector<std::string> values = values_of(text, own, argument);
        if (values.empty()) continue;
        one.arguments.emplace_back(argument.name, std::move(values));
        break;
      }
    }
    if (!one.arguments.empty()) found.push_back(std::move(one));
  }
  return found;
}

}  // namespace smurf::tools
