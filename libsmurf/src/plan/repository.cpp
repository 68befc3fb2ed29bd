// SPDX-License-Identifier: BSD-3-Clause
#include "plan/repository.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "base/files/canonical_paths.hpp"
#include "base/files/open_folder.hpp"
#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/ranges.hpp"

namespace smurf {
namespace {

/// The repository around a folder, looked up once per folder; "": none.
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

bool is_inside(const std::string& path, const std::string& folder) {
  const std::string inside = places::relative(path, folder);
  return !inside.empty() && inside != ".." && !inside.starts_with("../");
}

/// `target` is the target of a link in the repository at `root`; "": none.
bool leads_out(const std::string& target, const std::string& root) {
  if (root.empty()) return false;
  const auto has_target = [&](std::string_view history) {
    return is_inside(target, path::join(root, history));
  };
  return target.empty() || !is_inside(target, root) || ranges::any_of(kHistories, has_target);
}

}  // namespace

RepositoryPath in_repository() {
  const std::string here = places::canonical(".").value_or("");
  const std::string above = Repositories().above(here);
  const std::string root = above.empty() ? here : above;
  const auto find = [root](const std::string& path) {
    const auto whole = places::whole(path);
    if (!whole) return path;
    return is_inside(*whole, root) ? places::relative(*whole, root) : *whole;
  };
  // Thousands of findings may be in one file.
  return [find, known = std::map<std::string, std::string>()](const std::string& path) mutable {
    const auto [place, is_new] = known.try_emplace(path);
    if (is_new) place->second = find(path);
    return place->second;
  };
}

FollowedPath follow(const std::string& path) {
  const std::string whole = places::absolute(path);
  // Where no name on the way is a link, which is one question, the parts need not be looked at.
  if (canonical_now(path) == whole) return {{}, whole};
  Repositories repositories;
  std::string at;  // without links
  OpenFolder open("/");
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
