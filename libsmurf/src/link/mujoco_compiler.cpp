// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo 3.14, run: puts `meshdir`, else `assetdir`, before the path of each mesh; with
// `strippath="true"`, only the file name is kept.
#include "link/mujoco_compiler.hpp"

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "base/text/quoted.hpp"
#include "link/file_index.hpp"

namespace smurf {
namespace {

bool says(xml::View compiler, std::string_view name, std::string_view value) {
  const xml::Attribute* attribute = compiler ? compiler.attribute(name) : nullptr;
  return attribute != nullptr && attribute->value() == value;
}

/// Null if no folder is named.
const xml::Attribute* mesh_folder(xml::View compiler) {
  if (!compiler) return nullptr;
  const xml::Attribute* folder = compiler.attribute("meshdir");
  return folder != nullptr ? folder : compiler.attribute("assetdir");
}

/// Looks for meshes as MuJoCo does.
class MeshSearch {
 public:
  MeshSearch(const LinkedModel& model, const LoadContext& context)
      : context_(context),
        index_(context.files),
        compiler_(mujoco_compiler(model)),
        folder_(mesh_folder(compiler_)),
        strips_(says(compiler_, "strippath", "true")),
        urdf_folder_(path::parent(model.urdf_path)) {}

  void find(const urdf::Geometry& geometry) {
    const auto* mesh = std::get_if<urdf::Mesh>(&geometry.shape);
    if (mesh == nullptr || !mesh->filename || mesh->filename->empty()) return;
    const std::string path = path_of(*mesh->filename);
    if (index_.exists(path)) return;
    if (context_.files.is_denied(path)) {
      if (outside_.empty()) outside_ = path;
    } else if (lost_++ == 0) {
      first_ = path;
    }
  }

  void report() const {
    if (lost_ == 0 && outside_.empty()) return;
    const xml::Attribute* place = folder_ != nullptr ? folder_ : compiler_.attribute("strippath");
    if (lost_ == 0) {
      Diagnostic& diagnostic = context_.sink.report(
          rules::sml1647_mujoco_mesh_missing, place->value_span(),
          "MuJoCo looks for a mesh at " + quoted(outside_) + ", which lies outside of the project");
      diagnostic.when(kUncertain);
      diagnostic.help("add `--allow-outside` to look for it there");
      return;
    }
    Diagnostic& diagnostic = context_.sink.report(
        rules::sml1647_mujoco_mesh_missing, place->value_span(),
        "MuJoCo looks for a mesh at " + quoted(first_) + ", where there is none");
    if (lost_ > 1) {
      diagnostic.note(std::to_string(lost_ - 1) + " more meshes are missing, too");
    }
  }

 private:
  std::string path_of(std::string_view filename) const {
    if (strips_) filename = filename.substr(filename.find_last_of("/\\") + 1);
    const std::string folder =
        folder_ == nullptr ? urdf_folder_ : path::join(urdf_folder_, folder_->value());
    return path::join(folder, filename);
  }

  const LoadContext& context_;
  FileIndex index_;
  xml::View compiler_;
  const xml::Attribute* folder_;
  bool strips_;
  std::string urdf_folder_;
  std::string first_, outside_;
  std::size_t lost_ = 0;
};

}  // namespace

xml::View mujoco_compiler(const LinkedModel& model) {
  if (!model.robot || model.robot->document.root == xml::kNoElement) return {};
  const xml::View mujoco = model.robot->document.view().child("mujoco");
  return mujoco ? mujoco.child("compiler") : xml::View();
}

bool keeps_visuals(const LinkedModel& model) {
  return says(mujoco_compiler(model), "discardvisual", "false");
}

bool balances_inertias(const LinkedModel& model) {
  return says(mujoco_compiler(model), "balanceinertia", "true");
}

bool fuses_fixed_links(const LinkedModel& model) {
  return !says(mujoco_compiler(model), "fusestatic", "false");
}

bool is_told_where_meshes_are(const LinkedModel& model) {
  const xml::View compiler = mujoco_compiler(model);
  const xml::Attribute* folder = mesh_folder(compiler);
  return (folder != nullptr && !folder->value().empty()) || says(compiler, "strippath", "true");
}

void check_meshes_of_mujoco(const LinkedModel& model, const LoadContext& context) {
  if (!is_told_where_meshes_are(model)) return;
  MeshSearch search(model, context);
  const bool has_visuals = keeps_visuals(model);
  for (const urdf::Link& link : model.robot->links) {
    for (const urdf::Visual& visual : link.visuals) {
      if (has_visuals) search.find(visual.geometry);
    }
    for (const urdf::Collision& collision : link.collisions) search.find(collision.geometry);
  }
  search.report();
}

}  // namespace smurf
