// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "smurf/config.hpp"

namespace smurf {

std::string nearest_config(const std::string& path, const FileReader& files) {
  std::string folder = places::is_folder(path) ? path : std::string(path::parent(path));
  if (folder.empty()) folder = ".";
  // The search removes the last part of the path; it does not follow links.
  const std::string absolute = places::absolute(folder);
  for (auto level = std::count(absolute.begin(), absolute.end(), '/'); level >= 0; --level) {
    std::string config = path::join(folder, kConfigName);
    if (files.is_file(config)) return config;
    folder = path::join(folder, "..");
  }
  return {};
}

}  // namespace smurf
