// SPDX-License-Identifier: BSD-3-Clause
// Paths are looked up, files are never opened.
#include "link/resources.hpp"

#include <map>

#include "base/path.hpp"

namespace smurf {
namespace {

class Resolver {
 public:
  Resolver(std::string_view urdf_folder, const LoadContext& context)
      : folder_(urdf_folder), context_(context) {}

  MeshReference resolve(const Field<std::string>& filename, bool is_texture) {
    MeshReference reference;
    reference.span = filename.span;
    reference.filename = *filename;
    reference.is_texture = is_texture;
    reference.path = find(*filename);
    reference.exists = !reference.path.empty() && exists(reference.path);
    return reference;
  }

 private:
  std::string find(const std::string& filename) {
    constexpr std::string_view kPackage = "package://";
    constexpr std::string_view kFile = "file://";
    if (filename.starts_with(kPackage)) return find_in_package(filename.substr(kPackage.size()));
    if (filename.starts_with(kFile)) return path::normalize(filename.substr(kFile.size()));
    if (filename.find("://") != std::string::npos || filename.empty()) return {};
    return path::join(folder_, filename);
  }

  /// NAME/REST: the folder given for the package; else the nearest folder upward that is called
  /// NAME or that holds REST itself (Phobos takes the parent of the urdf/ folder, whatever its
  /// name).
  std::string find_in_package(const std::string& uri) {
    const std::size_t slash = uri.find('/');
    if (slash == std::string::npos || slash == 0) return {};
    const std::string name = uri.substr(0, slash);
    const std::string rest = uri.substr(slash + 1);
    if (const auto given = context_.packages.find(name); given != context_.packages.end()) {
      return path::join(given->second, rest);
    }
    constexpr int kLevels = 8;
    std::string folder = path::normalize(folder_.empty() ? "." : folder_);
    for (int level = 0; level < kLevels; ++level) {
      for (const std::string& candidate :
           {path::join(folder, name + "/" + rest), path::join(folder, rest)}) {
        if (exists(candidate)) return candidate;
      }
      folder = path::join(folder, "..");
    }
    return {};
  }

  bool exists(const std::string& path) {
    const auto known = known_.find(path);
    if (known != known_.end()) return known->second;
    return known_[path] = context_.files.is_file(path);
  }

  std::string folder_;
  const LoadContext& context_;
  std::map<std::string, bool> known_;
};

}  // namespace

std::vector<MeshReference> resolve_resources(const LinkedModel& model, const LoadContext& context) {
  Resolver resolver(path::parent(model.urdf_path), context);
  std::vector<MeshReference> references;
  const auto add_shape = [&](const urdf::Geometry& geometry) {
    const auto* mesh = std::get_if<urdf::Mesh>(&geometry.shape);
    if (mesh != nullptr && mesh->filename) {
      references.push_back(resolver.resolve(mesh->filename, false));
    }
  };
  const auto add_texture = [&](const urdf::Material& material) {
    if (material.texture) references.push_back(resolver.resolve(material.texture, true));
  };
  for (const urdf::Material& material : model.robot->materials) add_texture(material);
  for (const urdf::Link& link : model.robot->links) {
    for (const urdf::Visual& visual : link.visuals) {
      add_shape(visual.geometry);
      if (visual.material) add_texture(*visual.material);
    }
    for (const urdf::Collision& collision : link.collisions) add_shape(collision.geometry);
  }
  return references;
}

}  // namespace smurf
