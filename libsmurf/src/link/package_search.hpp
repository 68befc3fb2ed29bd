// SPDX-License-Identifier: BSD-3-Clause
// ROS packages around a file, by the names in their package.xml.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "link/companions/library.hpp"
#include "link/package_manifest.hpp"
#include "smurf/load.hpp"

namespace smurf {

/// Several threads may use it. What it finds does not depend on what was asked before.
class PackageSearch {
 public:
  /// `known`: of another search in the same files, or null.
  explicit PackageSearch(const FileReader& files, std::shared_ptr<CompanionFolders> known = {})
      : companions(std::make_shared<CompanionLibrary>(std::move(known))), files_(files) {}

  /// What the companions in these packages contain.
  const std::shared_ptr<CompanionLibrary> companions;

  /// The folder of a package: that of the file at `near`; then the one nearest to it, as far as
  /// files may be read, up to the folder that contains the repository of the file; then one in the
  /// folders that contain packages. Of several in one folder, the one that is nested least; of
  /// these, one in a folder of the name of the package.
  std::optional<std::string> find(const std::string& name, const std::string& near,
                                  const std::vector<std::string>& package_folders);

  /// The package.xml of a folder, which is read once.
  const PackageManifest& manifest(const std::string& folder);

 private:
  /// Packages in packages are seldom, and are not built by colcon: they are asked last.
  enum class Depth : std::uint8_t { packages, inside_of_packages };

  /// What is in a folder.
  struct Folder {
    bool has_package = false;
    bool is_repository = false;
    std::size_t entries = 0;
    std::vector<std::string> names;  ///< of what may be folders
  };

  /// What is in a folder and all its subfolders.
  struct Tree {
    std::map<std::string, std::vector<std::string>> packages;  ///< by name
    std::uint64_t entries = 0;
    int levels = 0;
    bool is_cut = false;  ///< there are more entries than are looked at
  };

  std::optional<std::string> search_around(const std::string& name, const std::string& folder);
  /// Searches `folder` and `last` folders above it.
  std::optional<std::string> search_upward(const std::string& name, const std::string& folder,
                                           const std::string& own, int last, Depth depth);
  /// How many folders above `near` are searched: without a limit, it would be the whole disk.
  int levels_above(std::string near, const std::string& own);
  /// The nearest folder with a package.xml, from `folder` upward; "" if there is none.
  std::string package_around(std::string folder);
  /// The name in the package.xml of a folder; "" if there is none.
  const std::string& name_in(const std::string& folder) { return manifest(folder).name; }
  bool is_package(const std::string& folder, std::string_view name) {
    return name_in(folder) == name;
  }
  /// Null if it was not searched before.
  const Tree* known_tree(const std::string& folder, Depth depth);
  const Tree& tree_of(const std::string& folder, Depth depth);
  void search(const std::string& folder, int level, Depth depth, Tree& found);
  bool take_known(const std::string& folder, int level, Depth depth, Tree& found);
  const Folder& look_into(const std::string& folder);
  /// The best of the packages in a folder, without reading all of them where it is near.
  std::optional<std::string> nearest(const std::string& folder, const std::string& name,
                                     Depth depth);
  std::optional<std::string> best(const std::vector<std::string>& folders, const std::string& name);

  struct TreeEntry {
    std::mutex mutex;  ///< held by the thread that searches; others wait for it
    std::atomic<bool> is_complete = false;
    Tree tree;
  };

  /// Two threads may find the same; what is kept stays where it is.
  template <class Key, class Value>
  const Value* find_known(const std::map<Key, Value>& all, const Key& key) const {
    const std::lock_guard lock(mutex_);
    const auto known = all.find(key);
    return known == all.end() ? nullptr : &known->second;
  }
  template <class Key, class Value>
  const Value& keep(std::map<Key, Value>& all, const Key& key, Value value) {
    const std::lock_guard lock(mutex_);
    return all.emplace(key, std::move(value)).first->second;
  }

  const FileReader& files_;
  mutable std::mutex mutex_;  ///< of the maps
  std::map<std::pair<std::string, Depth>, TreeEntry> trees_;
  std::map<std::string, PackageManifest> manifests_;  ///< by folder
  std::map<std::string, Folder> folders_;
  std::map<std::pair<std::string, std::string>, std::optional<std::string>> answers_;
};

/// That of the context, made at the first search.
PackageSearch& search_of(LoadContext& context);
/// The same as find(), but a folder that the user gave for the package comes first.
std::optional<std::string> find_package(const std::string& name, const std::string& near,
                                        LoadContext& context);

}  // namespace smurf
