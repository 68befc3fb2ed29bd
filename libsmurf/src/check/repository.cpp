// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/repository.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include "base/canonical_paths.hpp"
#include "base/ranges.hpp"

namespace smurf {
namespace {

namespace fs = std::filesystem;

/// The repository around folders, each of which is looked at once.
class Repositories {
 public:
  std::optional<fs::path> above(const fs::path& folder) {
    if (!folder.has_relative_path()) return std::nullopt;
    const auto [known, is_new] = known_.try_emplace(folder);
    if (!is_new) return known->second;
    return known->second = is_repository(folder) ? folder : above(folder.parent_path());
  }

 private:
  std::map<fs::path, std::optional<fs::path>> known_;
};

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path inside = path.lexically_relative(folder);
  return !inside.empty() && *inside.begin() != "..";
}

/// `target` is where a link leads that lies in the repository at `root`; "": nowhere.
bool leads_out(const fs::path& target, const std::optional<fs::path>& root) {
  if (!root) return false;
  const auto has_target = [&](std::string_view history) {
    return is_inside(target, *root / history);
  };
  return target.empty() || !is_inside(target, *root) || ranges::any_of(kHistories, has_target);
}

}  // namespace

bool is_repository(const fs::path& folder) {
  std::error_code ignored;
  // A link counts wherever it leads: whether something is there is not for a checkout to ask.
  return ranges::any_of(kHistories, [&](std::string_view history) {
    return fs::exists(fs::symlink_status(folder / history, ignored));
  });
}

RepositoryPath in_repository() {
  std::error_code error;
  const fs::path here = fs::canonical(".", error);
  const fs::path root = Repositories().above(here).value_or(here);
  return [root](const std::string& path) {
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, failed), failed);
    if (failed) return path;
    return (is_inside(whole, root) ? whole.lexically_relative(root) : whole).generic_string();
  };
}

FollowedPath follow(const std::string& path) {
  std::error_code error;
  Repositories repositories;
  // As texts: paths are copied part by part, and there may be thousands of parts.
  std::string at;  // without links
  const std::string whole = fs::absolute(path, error).string();
  for (std::size_t begin = 0; begin < whole.size();) {
    const std::size_t end = std::min(whole.find('/', begin), whole.size());
    const std::string part = whole.substr(begin, end - begin);
    begin = end + 1;
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      at.resize(at.empty() ? 0 : at.rfind('/'));
      continue;
    }
    const std::size_t folder = at.size();
    at += "/" + part;
    if (!fs::is_symlink(at, error)) continue;
    const auto target = canonical_now(at);
    if (leads_out(target.value_or(""), repositories.above(at.substr(0, folder)))) return {at, {}};
    if (target) at = *target == "/" ? "" : *target;
  }
  return {{}, at.empty() ? "/" : at};
}

std::string link_out_of_repository(const std::string& path) { return follow(path).link_out; }

}  // namespace smurf
