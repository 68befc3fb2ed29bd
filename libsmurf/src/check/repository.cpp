// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/repository.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include "base/canonical_paths.hpp"
#include "base/open_folder.hpp"
#include "base/path.hpp"
#include "base/ranges.hpp"

namespace smurf {
namespace {

namespace fs = std::filesystem;

/// The repository around folders, each of which is asked for once; "": none.
class Repositories {
 public:
  const std::string& above(const std::string& folder) {
    const auto [known, is_new] = known_.try_emplace(folder);
    if (!is_new) return known->second;
    OpenFolder open(folder);
    std::string_view at = folder;
    while (at.size() > 1 && !open.has_any(kHistories)) {
      at = path::parent(at);
      open.enter_above(std::string(at));
    }
    if (at.size() > 1) known->second = at;
    return known->second;
  }

 private:
  std::map<std::string, std::string> known_;
};

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path inside = path.lexically_relative(folder);
  return !inside.empty() && *inside.begin() != "..";
}

/// `target` is where a link leads that lies in the repository at `root`; "": nowhere.
bool leads_out(const fs::path& target, const fs::path& root) {
  if (root.empty()) return false;
  const auto has_target = [&](std::string_view history) {
    return is_inside(target, root / history);
  };
  return target.empty() || !is_inside(target, root) || ranges::any_of(kHistories, has_target);
}

}  // namespace

RepositoryPath in_repository() {
  std::error_code error;
  const fs::path here = fs::canonical(".", error);
  const std::string above = Repositories().above(here.string());
  const fs::path root = above.empty() ? here : fs::path(above);
  const auto find = [root](const std::string& path) {
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, failed), failed);
    if (failed) return path;
    return (is_inside(whole, root) ? whole.lexically_relative(root) : whole).generic_string();
  };
  // Thousands of findings may be in one file, and each of them asks.
  return [find, known = std::map<std::string, std::string>()](const std::string& path) mutable {
    const auto [place, is_new] = known.try_emplace(path);
    if (is_new) place->second = find(path);
    return place->second;
  };
}

FollowedPath follow(const std::string& path) {
  std::error_code error;
  Repositories repositories;
  std::string at;  // without links
  OpenFolder open("/");
  const std::string whole = fs::absolute(path, error).string();
  for (std::size_t begin = 0; begin < whole.size();) {
    const std::size_t end = std::min(whole.find('/', begin), whole.size());
    const std::string part = whole.substr(begin, end - begin);
    begin = end + 1;
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      at.resize(at.empty() ? 0 : at.rfind('/'));
      open.open(at.empty() ? "/" : at);
      continue;
    }
    const std::string folder = at;
    at += "/" + part;
    if (!open.target_of(part)) {
      open.enter(part);
      continue;
    }
    const auto target = canonical_now(at);
    if (leads_out(target.value_or(""), repositories.above(folder))) return {at, {}};
    if (target) at = *target == "/" ? "" : *target;
    open.open(at.empty() ? "/" : at);
  }
  return {{}, at.empty() ? "/" : at};
}

std::string link_out_of_repository(const std::string& path) { return follow(path).link_out; }

}  // namespace smurf
