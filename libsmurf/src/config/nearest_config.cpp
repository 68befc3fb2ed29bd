// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <system_error>

#include "base/path.hpp"
#include "smurf/config.hpp"

namespace smurf {

std::string nearest_config(const std::string& path, const FileReader& files) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  std::string folder = is_folder ? path : std::string(path::parent(path));
  if (folder.empty()) folder = ".";
  // The search removes the last part of the path; it does not follow links.
  const auto absolute = std::filesystem::absolute(folder, ignored);
  for (auto level = std::distance(absolute.begin(), absolute.end()); level > 0; --level) {
    std::string config = path::join(folder, kConfigName);
    if (files.is_file(config)) return config;
    folder = path::join(folder, "..");
  }
  return {};
}

}  // namespace smurf
