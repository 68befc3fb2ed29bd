// SPDX-License-Identifier: BSD-3-Clause
// Source: moveit_setup_assistant, urdf_config.cpp, srdf_config.cpp.
#include "link/companions/setup_assistant.hpp"

#include "base/files/path.hpp"
#include "link/package_search.hpp"

namespace smurf {

void find_missing_files(Companion& companion, LoadContext& context) {
  const yaml::View root = companion.document->view();
  const yaml::View config =
      root && root.is_mapping() ? root.find("moveit_setup_assistant_config") : yaml::View();
  if (!config || !config.is_mapping()) return;
  for (const std::string_view name : {"URDF", "SRDF"}) {
    yaml::View part = config.find(name);
    if (!part) part = config.find(name == "URDF" ? "urdf" : "srdf");  // in ROS 2
    const yaml::View path = part && part.is_mapping() ? part.find("relative_path") : yaml::View();
    if (!path || !path.is_scalar() || path.text().empty()) continue;
    std::string folder = companion.folder;
    if (const yaml::View package = part.find("package"); package && package.is_scalar()) {
      const auto found = find_package(std::string(package.text()),
                                      context.sources.path(companion.source), context);
      // Without a package, the path is absolute.
      if (!found || package.text().empty()) continue;
      folder = *found;
    } else if (name == "URDF") {
      continue;
    }
    const std::string file = path::join(folder, path.text());
    if (!context.files.is_file(file) && !context.files.is_denied(file)) {
      companion.missing.push_back(path.id());
    }
  }
}

}  // namespace smurf
