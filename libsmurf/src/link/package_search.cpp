// SPDX-License-Identifier: BSD-3-Clause
#include "link/package_search.hpp"

#include <algorithm>

#include "base/path.hpp"
#include "link/packages.hpp"

namespace smurf {
namespace {

constexpr int kLevels = 12;  // of folders, upward and downward
constexpr std::uint64_t kMostEntries = 200'000;

/// Folders of packages seldom have a point in their name; files nearly always do.
bool may_be_folder(const std::string& name, const std::string& path, const FileReader& files) {
  return name.find('.') == std::string::npos || !files.is_file(path);
}

}  // namespace

std::optional<std::string> PackageSearch::best(const Packages& packages, const std::string& name) {
  const auto found = packages.find(name);
  if (found == packages.end()) return std::nullopt;
  return *std::min_element(found->second.begin(), found->second.end(),
                           [](const std::string& a, const std::string& b) {
                             return a.size() != b.size() ? a.size() < b.size() : a < b;
                           });
}

void PackageSearch::search(const std::string& folder, int depth, Packages& found) {
  const auto known = known_.find(folder);
  if (known != known_.end()) {
    for (const auto& [name, folders] : known->second) {
      std::vector<std::string>& all = found[name];
      all.insert(all.end(), folders.begin(), folders.end());
    }
    return;
  }
  const std::vector<std::string> names = context_.files.list(folder);
  entries_ += names.size();
  if (std::binary_search(names.begin(), names.end(), "package.xml")) {
    constexpr std::uint64_t kMostBytes = 1U << 20U;
    const FileContent content = context_.files.read(path::join(folder, "package.xml"), kMostBytes);
    const std::string name = package_name_in(content.text);
    if (!name.empty()) found[name].push_back(folder);
  }
  if (depth >= kLevels) return;
  for (const std::string& name : names) {
    if (name.starts_with('.') || entries_ > kMostEntries) continue;
    const std::string inner = path::join(folder, name);
    if (may_be_folder(name, inner, context_.files)) search(inner, depth + 1, found);
  }
}

const PackageSearch::Packages& PackageSearch::packages_in(const std::string& folder) {
  const auto known = known_.find(folder);
  if (known != known_.end()) return known->second;
  Packages found;
  search(folder, 0, found);
  return known_.emplace(folder, std::move(found)).first->second;
}

std::optional<std::string> PackageSearch::find(const std::string& name, const std::string& near) {
  if (const auto given = context_.packages.find(name); given != context_.packages.end()) {
    return given->second;
  }
  std::string folder = path::normalize(path::parent(near).empty() ? "." : path::parent(near));
  for (int level = 0; level < kLevels; ++level) {
    if (auto found = best(packages_in(folder), name)) return found;
    const std::string above = path::join(folder, "..");
    if (above == folder) break;
    folder = above;
  }
  if (auto found = best(packages_in("."), name)) return found;
  for (const std::string& one : context_.package_folders) {
    if (auto found = best(packages_in(one), name)) return found;
  }
  return std::nullopt;
}

}  // namespace smurf
