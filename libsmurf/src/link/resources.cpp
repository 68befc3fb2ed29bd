// SPDX-License-Identifier: BSD-3-Clause
// Finds meshes and textures where readers look for them: URDF readers start at the URDF, MARS at
// the .smurf.
#include "link/resources.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/text/edits.hpp"
#include "base/text/suggest.hpp"
#include "link/packages.hpp"
#include "link/read_file.hpp"

namespace smurf {
namespace {

class Resolver {
 public:
  Resolver(const LinkedModel& model, LoadContext& context)
      : context_(context),
        index_(context.files),
        urdf_folder_(path::parent(model.urdf_path)),
        main_folder_(path::parent(model.path)),
        has_main_(model.has_main),
        packages_(context, model, index_) {}

  MeshReference mesh(const Field<std::string>& filename, bool is_texture) {
    MeshReference reference;
    reference.span = filename.span;
    reference.filename = *filename;
    reference.is_texture = is_texture;
    reference.path = find(*filename, &reference);
    // `folder/mesh.stl/` is a folder for the system, which the reader asks.
    const bool is_found =
        !reference.path.empty() && !filename->ends_with('/') && index_.exists(reference.path);
    const bool is_denied =
        !is_found && !reference.path.empty() && context_.files.is_denied(reference.path);
    reference.exists = is_found || is_denied;
    if (is_found && !is_address(*filename)) reference.meant = packages_.address_of(reference.path);
    reference.lies_beside = is_beside(*filename);
    if (!reference.exists) reference.similar = find_similar(reference);
    if (!reference.exists && reference.similar.empty()) reference.meant = find_meant(reference);
    if (has_main_ && !filename->empty() && !is_address(*filename)) see_as_mars(reference);
    if (context_.meshes == nullptr || (is_texture && !is_denied)) return reference;
    if (reference.exists) reference.file = open(reference.path);
    if (reference.mars_exists) reference.mars_file = open(reference.mars_path);
    return reference;
  }

  void look_again(MeshReference& reference) {
    reference.path = find(reference.filename);
    if (reference.path.empty()) return;
    reference.similar = find_similar(reference);
    if (reference.similar.empty()) reference.meant = find_meant(reference);
  }

  void texture(const Field<std::string>& filename, std::vector<TextureReference>& to) {
    if (!filename || filename->empty() || !has_main_) return;
    std::string path = path::join(main_folder_, *filename);
    const bool exists = index_.exists(path);
    const bool is_denied = !exists && context_.files.is_denied(path);
    to.push_back({filename.span, *filename, std::move(path), exists, is_denied});
  }

 private:
  bool is_beside(std::string_view filename) {
    const std::string_view name = filename.substr(filename.find_last_of("/\\") + 1);
    return !name.empty() && index_.exists(path::join(urdf_folder_, name));
  }

  static bool is_address(std::string_view filename) {
    return filename.find("://") != std::string_view::npos;
  }

  /// Tells `reference`, if it is given, how its package was found.
  std::string find(const std::string& filename, MeshReference* reference = nullptr) {
    constexpr std::string_view kPackage = "package://";
    constexpr std::string_view kFile = "file://";
    if (filename.starts_with("package:///"))
      return find_upward(filename.substr(kPackage.size() + 1));
    if (filename.starts_with(kPackage) && filename.find('/', kPackage.size()) == std::string::npos)
      return find_upward(filename.substr(kPackage.size()));
    constexpr std::string_view kModel = "model://";
    if (filename.starts_with(kModel)) {  // folders of models are searched like packages
      Packages::Place place = packages_.find(filename.substr(kModel.size()));
      return place.is_guess ? std::string() : std::move(place.path);
    }
    if (filename.starts_with(kPackage)) {
      Packages::Place place = packages_.find(filename.substr(kPackage.size()));
      if (reference != nullptr) {
        reference->is_package_guessed = place.is_guess;
        reference->is_package_elsewhere = place.is_elsewhere;
        reference->package_there = std::move(place.package);
      }
      return std::move(place.path);
    }
    if (filename.starts_with(kFile)) {
      return path::join(urdf_folder_, filename.substr(kFile.size()));
    }
    if (is_address(filename) || filename.empty()) return {};
    return path::join(urdf_folder_, filename);
  }

  /// A file from the folder of the URDF or one above it, where Bullet looks for `package:///PATH`
  /// and `package://FILE`.
  std::string find_upward(const std::string& path) {
    std::string folder = urdf_folder_;
    for (std::size_t level = 0; level <= kFoldersAbove; ++level) {
      std::string there = path::join(folder, path);
      if (!path.empty() && index_.exists(there)) return there;
      folder = path::join(folder, "..");
    }
    return {};
  }

  std::string find_similar(const MeshReference& reference) {
    std::string path = reference.path;
    if (reference.filename.find('\\') != std::string::npos) {
      std::string slashes = reference.filename;
      std::replace(slashes.begin(), slashes.end(), '\\', '/');
      path = find(slashes);
      if (!path.empty() && index_.exists(path)) return path;
    }
    if (path.empty() || reference.filename.ends_with('/')) return {};
    const auto other = index_.in_other_case(path);
    return other && index_.exists(*other) ? *other : std::string();
  }

  /// Similar names are looked for only for the first missing files, because a robot may name a
  /// hundred thousand.
  std::string find_meant(const MeshReference& reference) {
    constexpr int kMostSought = 20;
    if (reference.path.empty()) return {};
    if (reference.filename.ends_with('/') && index_.exists(reference.path)) {
      return reference.filename.substr(0, reference.filename.find_last_not_of('/') + 1);
    }
    if (std::string there = find_from_above(reference.filename); !there.empty()) return there;
    if (sought_ == kMostSought) return {};
    ++sought_;
    if (std::string beside = find_beside(reference); !beside.empty()) return beside;
    const std::string_view name = path::file_name(reference.filename);
    const std::string folder =
        reference.filename.substr(0, reference.filename.size() - name.size());
    const auto near =
        similar_name(name, index_.list(std::string(path::parent(reference.path))), fits_everywhere);
    // `bolt_m8.obj` for `bolt_m4.obj` is another part.
    return near && !differ_only_in_digits(name, *near) ? folder + *near : std::string();
  }

  /// Bullet and Isaac Gym also look in folders above the URDF, so that their files name meshes from
  /// there.
  std::string find_from_above(const std::string& filename) {
    if (is_address(filename) || path::is_absolute(filename)) return {};
    const std::string_view first = std::string_view(filename).substr(0, filename.find('/'));
    while (above_.size() < kFoldersAbove)
      above_.push_back(path::join(above_.empty() ? urdf_folder_ : above_.back(), ".."));
    for (const std::string& folder : above_) {
      if (!may_hold(folder, first)) continue;
      const std::string there = path::join(folder, filename);
      if (index_.exists(there)) return path::relative(there, urdf_folder_);
    }
    return {};
  }
  /// Looked up in a list, since a robot may name a hundred thousand files that are missing. Hidden
  /// names may exist without being listed, and a folder may be closed to listing.
  bool may_hold(const std::string& folder, std::string_view name) {
    if (name.empty() || name.starts_with('.')) return true;
    const std::vector<std::string>& names = index_.list(folder);
    return names.empty() || std::binary_search(names.begin(), names.end(), name);
  }

  /// A file of this name in a folder beside the one that is named: `visuals/` for `meshes/`.
  std::string find_beside(const MeshReference& reference) {
    const std::string_view name = path::file_name(reference.filename);
    const std::string_view folder = path::parent(reference.filename);
    const std::string_view own = path::file_name(folder);
    if (own.empty() || own == "." || own == "..") return {};
    const std::string above = path::join(path::parent(reference.path), "..");
    std::string found;
    for (const std::string& beside : index_.list(above)) {
      if (!fits_everywhere(beside)) continue;
      if (!index_.exists(path::join(above, beside + "/" + std::string(name)))) continue;
      if (!found.empty()) return {};  // several: which of them is meant?
      found = std::string(folder.substr(0, folder.size() - own.size())) + beside + "/" +
              std::string(name);
    }
    return found;
  }

  void see_as_mars(MeshReference& reference) {
    reference.mars_path = path::join(main_folder_, reference.filename);
    const std::string extension = path::to_lower(path::extension(reference.filename));
    if (!reference.is_texture && (extension == ".obj" || extension == ".stl")) {
      if (const auto bobj = find_bobj(reference.mars_path, extension)) reference.mars_path = *bobj;
    }
    reference.mars_exists =
        index_.exists(reference.mars_path) || context_.files.is_denied(reference.mars_path);
  }

  /// Looks for the .bobj beside the mesh, and in a folder bobj/ instead of stl/, obj/ or mars_obj/.
  /// Like MARS, replaces every occurrence of the folder name in the path (misc.cpp:241).
  std::optional<std::string> find_bobj(const std::string& mesh, std::string_view extension) {
    const std::string bobj = mesh.substr(0, mesh.size() - path::extension(mesh).size()) + ".bobj";
    if (index_.exists(bobj)) return bobj;
    const std::string_view folders[] = {"stl/", "mars_obj/", "obj/"};
    for (const std::string_view folder : folders) {
      if ((folder == "stl/") != (extension == ".stl")) continue;
      if (bobj.find(folder) == std::string::npos) continue;
      const std::string parallel = replace_all(bobj, folder, "bobj/");
      if (index_.exists(parallel)) return parallel;
    }
    return std::nullopt;
  }

  static std::string replace_all(std::string_view text, std::string_view from,
                                 std::string_view to) {
    std::string result;
    while (true) {
      const std::size_t at = text.find(from);
      if (at == std::string_view::npos) break;
      result.append(text.substr(0, at)).append(to);
      text.remove_prefix(at + from.size());
    }
    return result.append(text);
  }

  const MeshFile* open(const std::string& path) {
    return &context_.meshes->read(path, context_.files, context_.limits);
  }

  LoadContext& context_;
  FileIndex index_;
  std::string urdf_folder_;
  std::string main_folder_;
  bool has_main_;
  int sought_ = 0;  ///< number of missing files for which similar names were looked for
  std::vector<std::string> above_;  ///< the folders above that of the URDF, the nearest first
  Packages packages_;
};

}  // namespace

void resolve_resources(LinkedModel& model, LoadContext& context) {
  Resolver resolver(model, context);
  for (const MaterialAnnotation& material : model.annotations.materials) {
    resolver.texture(material.diffuse_texture, model.annotation_textures);
    resolver.texture(material.normal_texture, model.annotation_textures);
    resolver.texture(material.displacement_texture, model.annotation_textures);
  }
  if (!model.robot) return;
  const auto add_shape = [&](const urdf::Geometry& geometry) {
    const auto* mesh = std::get_if<urdf::Mesh>(&geometry.shape);
    if (mesh != nullptr && mesh->filename) {
      model.meshes.push_back(resolver.mesh(mesh->filename, false));
    }
  };
  const auto add_texture = [&](const urdf::Material& material) {
    if (material.texture) model.meshes.push_back(resolver.mesh(material.texture, true));
  };
  for (const urdf::Material& material : model.robot->materials) add_texture(material);
  for (const urdf::Link& link : model.robot->links) {
    for (const urdf::Visual& visual : link.visuals) {
      add_shape(visual.geometry);
      if (visual.material) add_texture(*visual.material);
    }
    for (const urdf::Collision& collision : link.collisions) add_shape(collision.geometry);
  }
  // A package may become known with a later file.
  for (MeshReference& mesh : model.meshes) {
    if (mesh.path.empty() && mesh.filename.starts_with("package://")) resolver.look_again(mesh);
  }
  std::stable_sort(
      model.meshes.begin(), model.meshes.end(),
      [](const MeshReference& a, const MeshReference& b) { return a.span.begin < b.span.begin; });
}

}  // namespace smurf
