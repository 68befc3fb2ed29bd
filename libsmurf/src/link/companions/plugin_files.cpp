// SPDX-License-Identifier: BSD-3-Clause
// Source: gz_ros2_control gz_ros2_control_plugin.cpp (e19b0ef).
#include "link/companions/plugin_files.hpp"

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/text/words.hpp"
#include "link/companions/places.hpp"
#include "link/package_search.hpp"

namespace smurf {
namespace {

constexpr std::uint64_t kMostBytesOfParameters = 1U << 20U;

/// Whether a folder above the file is a package, so that its contents are known.
bool is_in_package(const std::string& path, const FileReader& files) {
  std::string folder(path::parent(path));
  for (int level = 0; level < 4; ++level, folder = path::normalize(path::join(folder, ".."))) {
    if (files.is_file(path::join(folder, "package.xml"))) return true;
  }
  return false;
}

PluginFile::State state_of(const std::string& path, bool is_found, const FileReader& files) {
  const bool is_absolute = path.starts_with('/') || path.find(':') == 1;
  if ((!is_absolute && !is_found) || files.is_denied(path)) return PluginFile::State::unknown;
  const FileContent content = files.read(path, kMostBytesOfParameters);
  if (content.status != ReadStatus::ok) {
    const bool is_missing = !files.is_file(path) && is_in_package(path, files);
    return is_missing ? PluginFile::State::missing : PluginFile::State::unknown;
  }
  // With $(...), a launch file fills it in.
  if (content.text.find("ros__parameters") == std::string::npos) return PluginFile::State::other;
  return content.text.find("controller_manager") == std::string::npos
             ? PluginFile::State::other
             : PluginFile::State::controllers;
}

/// `$(find ...)` is absolute; reports name files in the current folder relative to it.
std::string shown_path(const std::string& path) {
  const std::string here = path::normalize(places::absolute(".")) + "/";
  return here.size() > 1 && path.starts_with(here) ? path.substr(here.size()) : path;
}

/// In a URDF that is not named as xacro, `$(find PACKAGE)/config/x.yaml` is as it was written.
std::string resolved(const std::string& path, const LinkedModel& model, LoadContext& context) {
  constexpr std::string_view kFind = "$(find ";
  const std::size_t close = path.find(')');
  if (!path.starts_with(kFind) || close == std::string::npos) return path;
  const std::string name(trimmed(path.substr(kFind.size(), close - kFind.size())));
  const auto folder = find_package(name, model.urdf_path, context);
  return folder ? path::normalize(*folder + path.substr(close + 1)) : path;
}

}  // namespace

bool is_control_plugin(std::string_view file_name) {
  return file_name.find("ros2_control") != std::string_view::npos;
}

std::vector<PluginFile> plugin_files_of(const LinkedModel& model, LoadContext& context) {
  std::vector<PluginFile> found;
  if (!model.robot) return found;
  const FileReader& files = context.files;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View plugin : gazebo) {
      const xml::Attribute* name = plugin.attribute("filename");
      if (plugin.name() != "plugin" || name == nullptr || !is_control_plugin(name->value())) {
        continue;
      }
      for (const xml::View one : plugin) {
        const std::string written(trimmed(one.text()));
        const std::string path = resolved(written, model, context);
        if (one.name() != "parameters" || path.empty()) continue;
        found.push_back({one.id(), shown_path(path), state_of(path, path != written, files)});
      }
    }
  }
  return found;
}

void add_plugin_files(std::string_view text, std::set<std::string, std::less<>>& ends) {
  constexpr std::string_view kOpen = "<parameters>";
  if (robot_name_in(text).empty()) return;  // a part of robots, perhaps of this one
  for (std::size_t at = text.find(kOpen); at != text.npos; at = text.find(kOpen, at + 1)) {
    const std::size_t begin = at + kOpen.size();
    const std::string_view path = trimmed(text.substr(begin, text.find('<', begin) - begin));
    // What stands behind `$(find x)`: files in several folders often have one name.
    // An argument in the path may be any folder.
    const std::string_view rest = path.substr(path.find(')') + 1);
    const bool is_literal = rest.find_first_of("${}") == rest.npos;
    if (rest.starts_with('/') && is_literal) ends.emplace(rest);
  }
}

}  // namespace smurf
