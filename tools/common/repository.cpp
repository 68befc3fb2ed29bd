// SPDX-License-Identifier: BSD-3-Clause
#include "common/repository.hpp"

#include <filesystem>
#include <system_error>

namespace smurf::tools {
namespace {

namespace fs = std::filesystem;

fs::path root_above(const fs::path& folder) {
  std::error_code ignored;
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
    if (fs::exists(at / ".git", ignored)) return at;
  }
  return folder;
}

}  // namespace

RepositoryPath in_repository() {
  std::error_code error;
  const fs::path root = root_above(fs::canonical(".", error));
  return [root](const std::string& path) {
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, failed), failed);
    if (failed) return path;
    const fs::path inside = whole.lexically_relative(root);
    const bool is_inside = !inside.empty() && *inside.begin() != "..";
    return (is_inside ? inside : whole).generic_string();
  };
}

}  // namespace smurf::tools
