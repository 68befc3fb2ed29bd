// SPDX-License-Identifier: BSD-3-Clause
// Source: moveit_setup_assistant, urdf_config.cpp, srdf_config.cpp.
#include "link/companions/setup_assistant.hpp"

#include "base/files/path.hpp"
#include "link/package_search.hpp"

namespace smurf {

std::optional<SetupFile> setup_file(const yaml::Document& document, std::string_view part,
                                    const std::string& path, LoadContext& context) {
  const yaml::View root = document.view();
  const yaml::View config =
      root && root.is_mapping() ? root.find("moveit_setup_assistant_config") : yaml::View();
  if (!config || !config.is_mapping()) return std::nullopt;
  yaml::View named = config.find(part);
  if (!named) named = config.find(path::to_lower(part));  // in ROS 2
  if (!named || !named.is_mapping()) return std::nullopt;
  const yaml::View relative = named.find("relative_path");
  if (!relative || !relative.is_scalar() || relative.text().empty()) return std::nullopt;
  std::string folder(path::parent(path));
  if (const yaml::View package = named.find("package"); package && package.is_scalar()) {
    const auto found = find_package(std::string(package.text()), path, context);
    // Without a package, the path is absolute.
    if (!found || package.text().empty()) return std::nullopt;
    folder = *found;
  } else if (part == "URDF") {
    return std::nullopt;
  }
  SetupFile file{relative.id(), path::join(folder, relative.text()), ""};
  const yaml::View words = named.find("xacro_args");
  if (words && words.is_scalar()) file.xacro_args = words.text();
  return file;
}

void find_missing_files(Companion& companion, LoadContext& context) {
  const std::string path =
      path::join(companion.folder, path::file_name(context.sources.path(companion.source)));
  for (const std::string_view part : {"URDF", "SRDF"}) {
    const auto file = setup_file(*companion.document, part, path, context);
    if (!file || context.files.is_file(file->path) || context.files.is_denied(file->path)) continue;
    companion.missing.push_back(file->relative_path);
  }
}

}  // namespace smurf
