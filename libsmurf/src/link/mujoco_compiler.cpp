// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo, run: puts `meshdir`, else `assetdir`, before the path of each mesh; with
// `strippath="true"`, which was the default before 3.7, only the file name is kept.
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

/// Looks for meshes as MuJoCo does, with their folders or only by their names.
class MeshSearch {
 public:
  MeshSearch(const LinkedModel& model, FileIndex& index, bool strips)
      : index_(index), strips_(strips), folder_(path::parent(model.urdf_path)) {
    const xml::Attribute* folder = mesh_folder(mujoco_compiler(model));
    if (folder != nullptr) folder_ = path::join(folder_, folder->value());
    const bool has_visuals = keeps_visuals(model);
    for (const urdf::Link& link : model.robot->links) {
      for (const urdf::Visual& visual : link.visuals) {
        if (has_visuals) find(visual.geometry);
      }
      for (const urdf::Collision& collision : link.collisions) find(collision.geometry);
    }
  }

  bool has_lost() const { return lost_ > 0; }
  /// A file that may be there, but was not looked up; empty if there is none.
  const std::string& outside() const { return outside_; }

  Diagnostic& report(Span place, std::string_view who, DiagnosticSink& sink) const {
    Diagnostic& diagnostic = sink.report(rules::sml1647_mujoco_mesh_missing, place,
                                         std::string(who) + " looks for a mesh at " +
                                             quoted(first_) + ", where there is none");
    if (lost_ > 1) {
      diagnostic.note(std::to_string(lost_ - 1) + " more meshes are missing, too");
    }
    return diagnostic;
  }

 private:
  void find(const urdf::Geometry& geometry) {
    const auto* mesh = std::get_if<urdf::Mesh>(&geometry.shape);
    if (mesh == nullptr || !mesh->filename || mesh->filename->empty()) return;
    std::string_view filename = *mesh->filename;
    if (strips_) filename = filename.substr(filename.find_last_of("/\\") + 1);
    const std::string path = path::join(folder_, filename);
    if (index_.exists(path)) return;
    if (index_.files().is_denied(path)) {
      if (outside_.empty()) outside_ = path;
    } else if (lost_++ == 0) {
      first_ = path;
    }
  }

  FileIndex& index_;
  bool strips_;
  std::string folder_;  ///< in which MuJoCo looks
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
  const xml::View compiler = mujoco_compiler(model);
  const xml::Attribute* strippath = compiler.attribute("strippath");
  const xml::Attribute* folder = mesh_folder(compiler);
  const Span place = (folder != nullptr ? folder : strippath)->value_span();
  FileIndex index(context.files);
  const bool strips = says(compiler, "strippath", "true");
  const MeshSearch search(model, index, strips);
  const MeshSearch before(model, index, strips || strippath == nullptr);
  if (search.has_lost()) {
    Diagnostic& diagnostic = search.report(place, "MuJoCo", context.sink);
    diagnostic.when(kLostToNewMujoco);
    if (before.has_lost()) diagnostic.when(kLostToOldMujoco);
  } else if (before.has_lost()) {
    before.report(place, "MuJoCo before 3.7", context.sink)
        .when(kLostToOldMujoco)
        .help("add `strippath=\"false\"`, or put the meshes into one folder");
  } else if (!search.outside().empty()) {
    Diagnostic& diagnostic =
        context.sink.report(rules::sml1647_mujoco_mesh_missing, place,
                            "MuJoCo looks for a mesh at " + quoted(search.outside()) +
                                ", which lies outside of the project");
    diagnostic.when(kUncertain);
    diagnostic.help("add `--allow-outside` to look for it there");
  }
}

}  // namespace smurf
