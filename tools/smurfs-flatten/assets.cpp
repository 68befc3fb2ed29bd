// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/assets.hpp"

#include <map>
#include <set>

#include "base/path.hpp"
#include "common/mesh_source.hpp"

namespace smurf::tools {
namespace {

class Redirection {
 public:
  Redirection(const std::string& folder, const FlattenOptions& options, const FileReader& files,
              const Limits& limits, const FlatScene& flat)
      : files_(files),
        current_(options.current_folder),
        output_(path::join(options.current_folder, options.output_folder)),
        plan_(files, limits, current_, folder, sources_of(flat)) {}

  /// Changes the name of a file; `file` is relative to the output's folder.
  std::string redirect(const std::string& file, const std::string& group) {
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
      for (const auto& [written, file] : model.resources) sources.insert(absolute(file));
      for (const auto& [written, file] : model.annotated_textures) sources.insert(absolute(file));
    }
    return sources;
  }

  const FileReader& files_;
  std::string current_, output_;
  CopyPlan plan_;
};

}  // namespace

AssetCopies redirect_assets(FlatScene& flat, const std::string& folder,
                            const FlattenOptions& options, const FileReader& files,
                            const Limits& limits) {
  Redirection redirection(folder, options, files, limits, flat);
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

}  // namespace smurf::tools
