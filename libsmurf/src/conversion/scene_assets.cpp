// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/scene_assets.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "base/files/path.hpp"
#include "base/text/edits.hpp"

namespace smurf {
namespace {

class Redirection {
 public:
  Redirection(const std::string& folder, const FlattenOptions& options, const FileReader& files,
              const Limits& limits, const FlatScene& flat,
              const std::function<bool(const std::string& file)>& stays)
      : files_(files),
        stays_(stays),
        current_(options.current_folder),
        output_(path::join(options.current_folder, options.output_folder)),
        plan_(files, limits, current_, folder, sources_of(flat)) {}

  /// Changes the name of a file; `file` is relative to the output's folder.
  std::string redirect(const std::string& file, const std::string& group) {
    if (stays_(file)) return file;
    const auto copy = plan_.copy_of(known_name(absolute(file), current_, files_), group);
    return copy ? path::relative(*copy, output_) : file;
  }

  AssetCopies take() { return plan_.take(); }

 private:
  std::string absolute(const std::string& file) const {
    return path::normalize(path::join(output_, file));
  }

  std::set<std::string> sources_of(const FlatScene& flat) const {
    std::set<std::string> sources;
    for (const FlatModel& model : flat.models) {
      for (const auto& [written, file] : model.resources) {
        if (!stays_(file)) sources.insert(absolute(file));
      }
      for (const auto& [written, file] : model.annotated_textures) sources.insert(absolute(file));
    }
    return sources;
  }

  const FileReader& files_;
  const std::function<bool(const std::string& file)>& stays_;
  std::string current_, output_;
  CopyPlan plan_;
};

}  // namespace

AssetCopies redirect_assets(FlatScene& flat, const std::string& folder,
                            const FlattenOptions& options, const FileReader& files,
                            const Limits& limits,
                            const std::function<bool(const std::string& file)>& stays) {
  Redirection redirection(folder, options, files, limits, flat, stays);
  for (FlatModel& model : flat.models) {
    for (auto& [written, file] : model.resources) file = redirection.redirect(file, model.id);
    for (auto& [written, file] : model.annotated_textures) {
      file = redirection.redirect(file, model.id);
    }
  }
  for (FlatInstance& instance : flat.instances) {
    for (FlatShape& shape : instance.shapes) {
      if (auto* map = std::get_if<FlatHeightmap>(&shape.geometry)) {
        map->file = redirection.redirect(map->file, "heightmaps");
      } else if (auto* mesh = std::get_if<FlatMesh>(&shape.geometry)) {
        mesh->file = redirection.redirect(mesh->file, "meshes");
      }
    }
  }
  return redirection.take();
}

AssetCopies named_copies(const AssetCopies& copies, std::string_view text,
                         const FlattenOptions& options) {
  if (copies.empty()) return {};
  const std::string output = path::join(options.current_folder, options.output_folder);
  std::map<std::string, std::size_t, std::less<>> by_name;
  std::map<std::string, std::size_t> by_place;
  std::size_t longest_name = 0;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const std::string place = path::join(options.current_folder, copies[i].to());
    const auto [name, is_new] = by_name.emplace(escape_xml(path::relative(place, output)), i);
    longest_name = std::max(longest_name, name->first.size());
    by_place.emplace(copies[i].inside, i);
  }
  std::set<std::size_t> named;
  std::vector<std::size_t> rest;  // whose own names are not followed yet
  const auto add = [&](std::size_t i) {
    if (named.insert(i).second) rest.push_back(i);
  };
  constexpr std::string_view kBefore = "\">";
  for (std::size_t at = text.find_first_of(kBefore); at != std::string_view::npos;
       at = text.find_first_of(kBefore, at + 1)) {
    const std::string_view longest = text.substr(at + 1, longest_name + 1);
    const auto found = by_name.find(longest.substr(0, longest.find_first_of("\"<")));
    if (found != by_name.end()) add(found->second);
  }
  while (!rest.empty()) {
    const AssetCopy& copy = copies[rest.back()];
    rest.pop_back();
    for (const std::string& place : copy.needs) {
      const auto found = by_place.find(place);
      if (found != by_place.end()) add(found->second);
    }
  }
  AssetCopies kept;
  for (const std::size_t i : named) kept.push_back(copies[i]);
  return kept;
}

}  // namespace smurf
