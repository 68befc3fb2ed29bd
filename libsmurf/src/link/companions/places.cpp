// SPDX-License-Identifier: BSD-3-Clause
#include "link/companions/places.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "link/package_search.hpp"

namespace smurf {
namespace {

constexpr int kLevels = 8;                    // from a description up to its package
constexpr std::size_t kMostFolders = 300;     // in which files are looked for
constexpr std::size_t kMostNeighbours = 400;  // folders that may be packages

/// Folders of a package without companions.
bool is_skipped(std::string_view name) {
  return name.starts_with('.') || !path::extension(name).empty() ||
         is_one_of(name, {"meshes", "include", "src", "test", "tests", "doc", "docs", "scripts",
                          "worlds", "textures", "materials", "media", "build", "install", "log"});
}

class Search {
 public:
  Search(const FileReader& files, PackageSearch& packages) : files_(files), search_(packages) {}

  CompanionPlaces run(const std::string& start) {
    const std::string folder = path::normalize(start.empty() ? "." : start);
    add(folder);
    std::string package = folder;
    int level = 0;
    while (level < kLevels && !is_package(package)) {
      package = path::join(package, "..");
      ++level;
    }
    add_usual(folder);
    if (level < kLevels) {
      add_package(package);
      own_ = places_.size();
      add_related(package);
    } else {
      own_ = places_.size();
    }
    return {std::move(places_), own_, std::move(packages_)};
  }

 private:
  bool is_package(const std::string& folder) { return manifest_of(folder).exists; }

  const PackageManifest& manifest_of(const std::string& folder) { return search_.manifest(folder); }

  bool is_full() const { return places_.size() >= kMostFolders; }

  void add(const std::string& folder) {
    if (!is_full() && seen_.insert(folder).second) places_.push_back(folder);
  }

  void add_usual(const std::string& folder) {
    for (const std::string_view name :
         {"srdf", "config", "../srdf", "../config", "../urdf", "../robots"}) {
      const std::string one = path::normalize(path::join(folder, name));
      if (!files_.list(one).empty()) add(one);
    }
  }

  void add_package(const std::string& package) {
    add(package);
    for (const std::string& name : files_.list(package)) {
      if (is_skipped(name) || is_full()) continue;
      const std::string folder = path::join(package, name);
      const std::vector<std::string> inner = files_.list(folder);
      if (inner.empty()) continue;
      add(folder);
      for (const std::string& one : inner) {
        if (!is_skipped(one) && !files_.is_file(path::join(folder, one))) {
          add(path::join(folder, one));
        }
      }
    }
  }

  /// The packages beside a package, and those one level above and below.
  std::vector<std::string> neighbours(const std::string& package) {
    std::vector<std::string> found;
    std::size_t looked_at = 0;
    const std::string around = path::join(package, "..");
    for (const std::string& folder : {around, path::join(around, "..")}) {
      for (const std::string& name : files_.list(folder)) {
        if (is_skipped(name) || ++looked_at > kMostNeighbours) continue;
        const std::string one = path::join(folder, name);
        if (is_package(one)) {
          found.push_back(one);
        } else if (folder == around) {
          for (const std::string& inner : files_.list(one)) {
            if (is_skipped(inner) || ++looked_at > kMostNeighbours) continue;
            if (is_package(path::join(one, inner))) found.push_back(path::join(one, inner));
          }
        }
      }
    }
    return found;
  }

  void add_related(const std::string& package) {
    const PackageManifest& own = manifest_of(package);
    packages_.push_back({own.name, package});
    for (const std::string& other : neighbours(package)) {
      if (seen_.contains(other)) continue;
      const PackageManifest& manifest = manifest_of(other);
      if (manifest.name.empty() || manifest.name == own.name) continue;  // a copy
      packages_.push_back({manifest.name, other});
      const bool is_related =
          manifest.dependencies.contains(own.name) || own.dependencies.contains(manifest.name);
      if (is_related) add_package(other);
    }
  }

  const FileReader& files_;
  PackageSearch& search_;
  std::vector<std::string> places_;
  std::size_t own_ = 0;  ///< places of the package itself
  std::vector<NearPackage> packages_;
  std::set<std::string> seen_;
};

}  // namespace

CompanionPlaces companion_places(const std::string& folder, const FileReader& files,
                                 PackageSearch& packages) {
  return Search(files, packages).run(folder);
}

std::string_view robot_name_in(std::string_view text) {
  for (std::size_t at = text.find("<robot"); at != std::string_view::npos;
       at = text.find("<robot", at + 1)) {
    const std::size_t end = text.find('>', at);
    const std::string_view tag = text.substr(at, end == std::string_view::npos ? end : end - at);
    if (tag.size() < 8 || !is_blank(tag[6])) continue;
    for (std::size_t name = tag.find("name"); name != std::string_view::npos;
         name = tag.find("name", name + 1)) {
      std::string_view rest = trimmed(tag.substr(name + 4));
      if (!is_blank(tag[name - 1]) || !rest.starts_with('=')) continue;
      rest = trimmed(rest.substr(1));
      if (rest.empty() || (rest.front() != '"' && rest.front() != '\'')) continue;
      const std::size_t close = rest.find(rest.front(), 1);
      return close == std::string_view::npos ? std::string_view()
                                             : trimmed(rest.substr(1, close - 1));
    }
  }
  return {};
}

}  // namespace smurf
