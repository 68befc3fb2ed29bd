// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/repository.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

namespace smurf {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> root_above(const fs::path& folder) {
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
    if (is_repository(at)) return at;
  }
  return std::nullopt;
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path inside = path.lexically_relative(folder);
  return !inside.empty() && *inside.begin() != "..";
}

bool leads_out(const fs::path& link, const fs::path& folder) {
  const auto root = root_above(folder);
  if (!root) return false;
  std::error_code failed;
  const fs::path target = fs::canonical(link, failed);  // fails where the link leads nowhere
  const auto has_target = [&](std::string_view history) {
    return is_inside(target, *root / history);
  };
  return failed || !is_inside(target, *root) || std::ranges::any_of(kHistories, has_target);
}

}  // namespace

bool is_repository(const fs::path& folder) {
  std::error_code ignored;
  // A link counts wherever it leads: whether something is there is not for a checkout to ask.
  return std::ranges::any_of(kHistories, [&](std::string_view history) {
    return fs::exists(fs::symlink_status(folder / history, ignored));
  });
}

RepositoryPath in_repository() {
  std::error_code error;
  const fs::path here = fs::canonical(".", error);
  const fs::path root = root_above(here).value_or(here);
  return [root](const std::string& path) {
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, failed), failed);
    if (failed) return path;
    return (is_inside(whole, root) ? whole.lexically_relative(root) : whole).generic_string();
  };
}

std::string link_out_of_repository(const std::string& path) {
  std::error_code error;
  fs::path at;  // without links
  for (const fs::path& part : fs::absolute(path, error)) {
    const fs::path next = at / part;
    if (fs::is_symlink(next, error) && leads_out(next, at)) return next.string();
    at = fs::weakly_canonical(next, error);
    if (error) break;
  }
  return {};
}

}  // namespace smurf
