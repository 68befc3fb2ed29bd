// SPDX-License-Identifier: BSD-3-Clause
#include "link/package_search.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "base/files/path.hpp"

namespace smurf {
namespace {

constexpr int kLevels = 12;             // of folders, upward and downward
constexpr int kLevelsAbovePackage = 2;  // where no repository tells how far the workspace reaches
constexpr std::uint64_t kMostEntries = 200'000;

/// Folders of packages seldom have a point in their name; files nearly always do.
bool may_be_folder(const std::string& name) {
  const std::size_t point = name.rfind('.');
  if (point == std::string::npos) return true;
  // Most files of packages. To ask for each of them takes longer than to expand a robot.
  constexpr std::array<std::string_view, 36> kOfFiles = {
      "3dm", "bag",  "bmp",    "cfg", "cpp", "dae", "gif", "gz",   "h",     "hpp", "in",   "jpeg",
      "jpg", "json", "launch", "md",  "mtl", "obj", "pdf", "png",  "ply",   "py",  "rst",  "rviz",
      "sdf", "srdf", "step",   "stl", "svg", "tif", "txt", "urdf", "xacro", "xml", "yaml", "yml"};
  const std::string ending = path::to_lower(std::string_view(name).substr(point + 1));
  return std::find(kOfFiles.begin(), kOfFiles.end(), ending) == kOfFiles.end();
}

/// Whether a folder is marked as one without packages to use: by its owner, or as one that a build,
/// npm or Python fills.
bool is_left_out(const std::string& path, const std::vector<std::string>& names) {
  constexpr std::array<std::string_view, 4> kMarks = {"AMENT_IGNORE", "CMakeCache.txt",
                                                      "COLCON_IGNORE", "pyvenv.cfg"};
  return path::file_name(path) == "node_modules" ||
         std::any_of(kMarks.begin(), kMarks.end(), [&](std::string_view mark) {
           return std::binary_search(names.begin(), names.end(), mark);
         });
}

}  // namespace

std::optional<std::string> PackageSearch::best(const std::vector<std::string>& folders,
                                               const std::string& name) {
  const auto rank = [&](const std::string& one) {
    return std::tuple(std::count(one.begin(), one.end(), '/'), path::file_name(one) != name,
                      one.size(), std::string_view(one));
  };
  const auto found =
      std::min_element(folders.begin(), folders.end(),
                       [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return found == folders.end() ? std::nullopt : std::optional(*found);
}

const PackageSearch::Folder& PackageSearch::look_into(const std::string& path) {
  if (const Folder* known = find_known(folders_, path)) return *known;
  Folder folder;
  std::vector<std::string> names = files_.list(path);
  folder.entries = names.size();
  folder.has_package = std::binary_search(names.begin(), names.end(), kPackageFile);
  folder.is_repository = std::binary_search(names.begin(), names.end(), ".git");
  if (is_left_out(path, names)) names.clear();
  // A file is listed as an empty folder. To ask what it is would make it an input of the run.
  std::erase_if(
      names, [](const std::string& name) { return name.starts_with('.') || !may_be_folder(name); });
  folder.names = std::move(names);
  return keep(folders_, path, std::move(folder));
}

std::optional<std::string> PackageSearch::nearest(const std::string& folder,
                                                  const std::string& name, Depth depth) {
  constexpr int kNear = 2;            // levels
  constexpr std::size_t kMost = 100;  // folders of a level
  if (is_package(folder, name)) return folder;
  const bool is_known = known_tree(folder, depth) != nullptr;
  std::vector<std::string> level{folder};
  for (int i = 0; i < kNear && !is_known; ++i) {
    std::vector<std::string> inside;
    for (const std::string& one : level) {
      if (depth == Depth::packages && !name_in(one).empty()) continue;
      const Folder& in_it = look_into(one);
      if (depth == Depth::packages && in_it.has_package) continue;
      for (const std::string& inner : in_it.names) inside.push_back(path::join(one, inner));
    }
    if (inside.size() > kMost) break;
    std::vector<std::string> found;
    const auto add = [&](bool is_called_so) {
      for (const std::string& one : inside) {
        const bool is_wanted = (path::file_name(one) == name) == is_called_so;
        if (is_wanted && is_package(one, name)) found.push_back(one);
      }
      return !found.empty();
    };
    if (add(true) || add(false)) return best(found, name);
    level = std::move(inside);
  }
  const auto& all = tree_of(folder, depth).packages;
  const auto found = all.find(name);
  return found == all.end() ? std::nullopt : best(found->second, name);
}

/// Takes what was found in a folder before, if the search would find the same again.
bool PackageSearch::take_known(const std::string& folder, int level, Depth depth, Tree& found) {
  const Tree* known = known_tree(folder, depth);
  if (known == nullptr) return false;
  const Tree& tree = *known;
  if (tree.is_cut || level + tree.levels > kLevels || found.entries + tree.entries > kMostEntries) {
    return false;
  }
  for (const auto& [name, folders] : tree.packages) {
    std::vector<std::string>& all = found.packages[name];
    all.insert(all.end(), folders.begin(), folders.end());
  }
  found.entries += tree.entries;
  found.levels = std::max(found.levels, level + tree.levels);
  return true;
}

void PackageSearch::search(const std::string& folder, int level, Depth depth, Tree& found) {
  if (take_known(folder, level, depth, found)) return;
  found.levels = std::max(found.levels, level);
  if (depth == Depth::packages) {  // most folders are packages, and their entries are not needed
    if (const std::string& name = name_in(folder); !name.empty()) {
      found.packages[name].push_back(folder);
      return;
    }
  }
  const Folder& inside = look_into(folder);
  found.entries += inside.entries;
  if (inside.has_package) {
    const std::string& name = name_in(folder);
    if (!name.empty()) found.packages[name].push_back(folder);
    if (depth == Depth::packages) return;
  }
  if (level >= kLevels) return;
  for (const std::string& name : inside.names) {
    found.is_cut = found.is_cut || found.entries > kMostEntries;
    if (found.is_cut) return;
    search(path::join(folder, name), level + 1, depth, found);
  }
}

const PackageSearch::Tree* PackageSearch::known_tree(const std::string& folder, Depth depth) {
  const std::lock_guard lock(mutex_);
  const auto known = trees_.find({folder, depth});
  return known == trees_.end() || !known->second.is_complete ? nullptr : &known->second.tree;
}

const PackageSearch::Tree& PackageSearch::tree_of(const std::string& folder, Depth depth) {
  TreeEntry& entry = [&]() -> TreeEntry& {
    const std::lock_guard lock(mutex_);
    return trees_[{folder, depth}];
  }();
  const std::lock_guard lock(entry.mutex);
  if (!entry.is_complete) search(folder, 0, depth, entry.tree);
  entry.is_complete = true;
  return entry.tree;
}

const PackageManifest& PackageSearch::manifest(const std::string& folder) {
  if (const PackageManifest* known = find_known(manifests_, folder)) return *known;
  return keep(manifests_, folder, manifest_in(folder, files_));
}

std::string PackageSearch::package_around(std::string folder) {
  for (int level = 0; level < kLevels; ++level) {
    if (!name_in(folder).empty()) return folder;
    std::string above = path::join(folder, "..");
    if (above == folder) break;
    folder = std::move(above);
  }
  return {};
}

std::optional<std::string> PackageSearch::find(const std::string& name, const std::string& near,
                                               const std::vector<std::string>& package_folders) {
  const std::string folder = path::normalize(path::parent(near).empty() ? "." : path::parent(near));
  if (const auto* known = find_known(answers_, {name, folder})) return *known;
  std::optional<std::string> answer = search_around(name, folder);
  for (const std::string& one : package_folders) {
    if (answer) break;
    answer = nearest(one, name, Depth::inside_of_packages);
  }
  return keep(answers_, {name, folder}, std::move(answer));
}

int PackageSearch::levels_above(std::string folder, const std::string& own) {
  int last = kLevels - 1;
  for (int level = 0; level < kLevels; ++level) {
    // Repositories of a workspace lie beside each other.
    if (look_into(folder).is_repository) return level + 1;
    if (folder == own) last = level + kLevelsAbovePackage;
    std::string above = path::join(folder, "..");
    // `..` of the outermost folder is this folder.
    if (files_.identity(above) == files_.identity(folder)) return std::min(last, level);
    folder = std::move(above);
  }
  return last;
}

std::optional<std::string> PackageSearch::search_upward(const std::string& name,
                                                        const std::string& near,
                                                        const std::string& own, int last,
                                                        Depth depth) {
  std::string folder = near;
  bool is_in_own = depth == Depth::packages && !own.empty();
  for (int level = 0; level <= last; ++level) {
    is_in_own = is_in_own && folder != own;
    // Before all that is in the folder, which may be much.
    if (is_package(folder, name)) return folder;
    if (std::string inner = path::join(folder, name); is_package(inner, name)) return inner;
    if (!is_in_own) {
      if (auto found = nearest(folder, name, depth)) return found;
      const Tree* searched = known_tree(folder, depth);
      if (searched != nullptr && searched->is_cut) break;  // so are those that contain it
    }
    folder = path::join(folder, "..");
  }
  return nearest(".", name, depth);
}

std::optional<std::string> PackageSearch::search_around(const std::string& name,
                                                        const std::string& near) {
  // Most robots name files of their own package.
  const std::string own = package_around(near);
  if (!own.empty() && is_package(own, name)) return own;
  const int last = levels_above(near, own);
  if (auto found = search_upward(name, near, own, last, Depth::packages)) return found;
  return search_upward(name, near, own, last, Depth::inside_of_packages);
}

PackageSearch& search_of(LoadContext& context) {
  if (!context.package_search) {
    context.package_search = std::make_shared<PackageSearch>(context.files);
  }
  return *context.package_search;
}

std::optional<std::string> find_package(const std::string& name, const std::string& near,
                                        LoadContext& context) {
  const auto given = context.packages.find(name);
  if (given != context.packages.end()) return given->second;
  return search_of(context).find(name, near, context.package_folders);
}

}  // namespace smurf
