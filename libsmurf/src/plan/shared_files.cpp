// SPDX-License-Identifier: BSD-3-Clause
#include "plan/shared_files.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "link/companions/places.hpp"
#include "link/package_search.hpp"
#include "smurf/companions.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostSharedPlaces = 10;
constexpr std::size_t kMostSharingRobots = 400;            // that are searched for a definition
constexpr std::uint64_t kMostBytesOfSharing = 16U << 20U;  // of such a robot

/// Whether a text has an element `tag` with this attribute `name`.
bool defines_name(std::string_view text, std::string_view tag, std::string_view name) {
  const std::string begin = "<" + std::string(tag);
  for (std::size_t at = text.find(begin); at != std::string_view::npos;
       at = text.find(begin, at + 1)) {
    const std::size_t end = text.find_first_of("<>", at + 1);  // each byte is read once
    const std::string_view inner = text.substr(at, end == std::string_view::npos ? end : end - at);
    if (inner.size() <= begin.size() || !is_blank(inner[begin.size()])) continue;
    for (const char quote : {'"', '\''}) {
      const std::string value = std::string("name=") + quote + std::string(name) + quote;
      if (inner.find(value) != std::string_view::npos) return true;
    }
  }
  return false;
}

class SharedSearch {
 public:
  SharedSearch(std::span<const std::vector<Reference>> loaded, const SourceMap& sources,
               const FileReader& files, const std::function<bool(const std::string&)>& is_loaded)
      : loaded_(loaded),
        sources_(sources),
        files_(files),
        is_loaded_(is_loaded),
        packages_(files) {}

  void look_for(const Rename& rename) {
    uses_.clear();
    for (const std::vector<Reference>& names : loaded_) read(names, rename);
    for (const auto& [path, use] : uses_) judge(path, use, rename);
    tell();
  }

  SharedFiles take() { return std::move(found_); }

 private:
  using SharedPlace = std::pair<std::string, std::uint32_t>;

  /// How a surrounding file names the thing.
  struct SharedUse {
    std::set<SharedPlace> definitions;
    const Reference* first = nullptr;
    bool is_needed = false;  ///< not only remembered
  };

  static bool is_of(const Rename& rename, const Reference& one) {
    return one.is_known() && one.name == rename.from && (!rename.kind || *rename.kind == one.kind);
  }

  /// The names of one robot.
  void read(const std::vector<Reference>& names, const Rename& rename) {
    std::set<SharedPlace> definitions;
    for (const Reference& one : names) {
      if (one.is_definition && is_of(rename, one))
        definitions.emplace(sources_.path(one.span.source), one.span.begin);
    }
    for (const Reference& one : names) {
      const bool may_be_shared =
          one.around == Reference::Around::any || one.around == Reference::Around::memory;
      // Whether it is given to two robots is known; both then have it.
      if (!is_of(rename, one) || (!may_be_shared && one.around != Reference::Around::own)) continue;
      SharedUse& use = uses_[sources_.path(one.span.source)];
      if (may_be_shared) only_names_.insert(sources_.path(one.span.source));
      use.definitions.insert(definitions.begin(), definitions.end());
      if (use.first == nullptr) use.first = &one;
      use.is_needed = use.is_needed || one.around != Reference::Around::memory;
    }
  }

  void judge(const std::string& path, const SharedUse& use, const Rename& rename) {
    std::string other;
    if (use.definitions.size() > 1) {
      other = use.definitions.rbegin()->first;
      const std::string& first = use.definitions.begin()->first;
      add(path, use, "the " + thing(*use.first) + " of '" + first + "' or that of '" + other + "'");
      return;
    }
    if (!only_names_.contains(path)) return;
    other = unloaded_robot(path, *use.first, rename.from);
    if (other.empty()) return;
    add(path, use, "the " + thing(*use.first) + " of '" + other + "'");
  }

  static std::string thing(const Reference& one) {
    return std::string(to_string(one.kind)) + " " + quoted(one.name);
  }

  void add(const std::string& path, const SharedUse& use, const std::string& what) {
    found_.paths.insert(path);
    if (!use.is_needed) return;
    const Span span = use.first->span;
    const std::size_t line = sources_.position(span.source, span.begin).line;
    places_[what].push_back("'" + path + "' (line " + std::to_string(line) + ")");
  }

  /// One sentence for all files.
  void tell() {
    for (const auto& [what, places] : places_) {
      found_.problems.push_back(
          what + " may be meant in " +
          enumerated_to(kMostSharedPlaces, places, "more file", "more files") +
          "; tie files to a robot with `companions` in .smurf-lint.yaml, or leave them as they are "
          "with `smurf-lint --rename` and --force");
    }
    places_.clear();
  }

  /// A robot around the file, or a part of one, that was not loaded and has the name.
  std::string unloaded_robot(const std::string& path, const Reference& one, std::string_view name) {
    const std::string tag(to_string(one.kind));
    if (tag != "link" && tag != "joint") return {};
    std::string folder(path::parent(path));
    if (folder.empty()) folder = ".";
    std::size_t seen = 0;
    for (const std::string& place : companion_places(folder, files_, packages_).folders) {
      for (const std::string& file : files_.list(place)) {
        const std::string robot = path::join(place, file);
        const std::string extension = path::to_lower(path::extension(file));
        const bool may_be_robot =
            is_one_of(extension, {".urdf", ".xacro"}) && !is_companion_path(robot);
        if (!may_be_robot || is_loaded_(robot)) continue;
        if (++seen > kMostSharingRobots) return {};
        const FileContent content = files_.read(robot, kMostBytesOfSharing);
        if (content.status == ReadStatus::ok && defines_name(content.text, tag, name)) return robot;
      }
    }
    return {};
  }

  std::span<const std::vector<Reference>> loaded_;
  const SourceMap& sources_;
  const FileReader& files_;
  const std::function<bool(const std::string&)>& is_loaded_;
  PackageSearch packages_;
  std::map<std::string, SharedUse> uses_;                   ///< of one rename, by path
  std::map<std::string, std::vector<std::string>> places_;  ///< by what may be meant there
  std::set<std::string> only_names_;                        ///< files that are not given to a robot
  SharedFiles found_;
};

}  // namespace

SharedFiles shared_files(std::span<const std::vector<Reference>> loaded,
                         std::span<const Rename> renames, const SourceMap& sources,
                         const FileReader& files,
                         const std::function<bool(const std::string& path)>& is_loaded) {
  SharedSearch search(loaded, sources, files, is_loaded);
  for (const Rename& one : renames) search.look_for(one);
  return search.take();
}

}  // namespace smurf
