// SPDX-License-Identifier: BSD-3-Clause
#include "link/companions/places.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "smurf/companions.hpp"

namespace smurf {
namespace {

constexpr int kLevels = 8;                       // from a description up to its package
constexpr std::size_t kMostFolders = 300;        // in which files are looked for
constexpr std::size_t kMostNeighbours = 400;     // folders that may be packages
constexpr std::uint64_t kMostBytes = 1U << 20U;  // of a package.xml

/// Folders of a package without companions.
bool is_skipped(std::string_view name) {
  return name.starts_with('.') || !path::extension(name).empty() ||
         is_one_of(name, {"meshes", "include", "src", "test", "tests", "doc", "docs", "scripts",
                          "worlds", "textures", "materials", "media", "build", "install", "log"});
}

/// Whether a YAML file with this name may be a companion.
bool is_promising_yaml(std::string_view lower) {
  if (!lower.ends_with(".yaml") && !lower.ends_with(".yml")) return false;
  constexpr std::string_view kWords[] = {"control",  "limits", "kinematics", "ompl",
                                         "planning", "moveit", "param",      "sensors"};
  return std::any_of(std::begin(kWords), std::end(kWords), [&](std::string_view word) {
    return lower.find(word) != std::string_view::npos;
  });
}

class Search {
 public:
  explicit Search(const FileReader& files) : files_(files) {}

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
      add_related(package);
    }
    return {std::move(places_), std::move(packages_)};
  }

 private:
  bool is_package(const std::string& folder) { return manifest_of(folder).has_value(); }

  /// The text of the package.xml in a folder. Hundreds of folders are asked, some of them twice.
  const std::optional<std::string>& manifest_of(const std::string& folder) {
    const auto [known, is_new] = manifests_.try_emplace(folder);
    if (is_new) {
      FileContent content = files_.read(path::join(folder, "package.xml"), kMostBytes);
      if (content.status == ReadStatus::ok) known->second = std::move(content.text);
    }
    return known->second;
  }

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

  static std::string_view name_in(std::string_view manifest) {
    const std::size_t begin = manifest.find("<name>");
    const std::size_t end = manifest.find("</name>", begin);
    if (begin == std::string_view::npos || end == std::string_view::npos) return {};
    return trimmed(manifest.substr(begin + 6, end - begin - 6));
  }

  static bool names(std::string_view manifest, std::string_view package) {
    return !package.empty() &&
           manifest.find(">" + std::string(package) + "<") != std::string_view::npos;
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
    const std::string_view own = *manifest_of(package);
    const std::string_view name = name_in(own);
    packages_.push_back({std::string(name), package});
    for (const std::string& other : neighbours(package)) {
      if (seen_.contains(other)) continue;
      const std::string_view manifest = *manifest_of(other);
      if (name_in(manifest) == name) continue;  // a copy
      packages_.push_back({std::string(name_in(manifest)), other});
      if (names(manifest, name) || names(own, name_in(manifest))) add_package(other);
    }
  }

  const FileReader& files_;
  std::vector<std::string> places_;
  std::vector<NearPackage> packages_;
  std::set<std::string> seen_;
  std::map<std::string, std::optional<std::string>> manifests_;  ///< by folder
};

}  // namespace

NamesInFolder::NamesInFolder(std::vector<std::string> all) {
  for (std::string& name : all) {
    const bool is_hidden = name.starts_with('.');
    const std::string lower = path::to_lower(name);
    if (!is_hidden && lower.ends_with(".urdf")) urdfs.push_back(name);
    if (!is_hidden && lower.ends_with(".xacro")) xacros.push_back(name);
    const bool is_companion = is_hidden ? name == ".setup_assistant" : is_promising_yaml(lower);
    if (is_companion || is_companion_path(name)) companions.push_back(std::move(name));
  }
}

CompanionPlaces companion_places(const std::string& folder, const FileReader& files) {
  return Search(files).run(folder);
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
