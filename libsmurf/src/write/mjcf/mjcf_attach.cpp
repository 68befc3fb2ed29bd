// SPDX-License-Identifier: BSD-3-Clause
// Every model is named once and attached for each of its instances. An attached tree cannot contain
// other bodies (MuJoCo 3.14 drops them silently), so an instance that is anchored to a link of
// another model is a free body held by a weld.
#include "write/mjcf/mjcf_attach.hpp"

#include <unordered_set>

#include "base/numbers/numbers.hpp"
#include "write/mjcf/mjcf_parts.hpp"

namespace smurf {
namespace {

class AttachWriter : MjcfParts {
 public:
  using MjcfParts::MjcfParts;

  std::string run() {
    check_models();
    xml_.open("mujoco", {{"model", "scene"}});
    add_settings();
    xml_.open("asset");
    add_models();
    add_heightmaps();
    xml_.close();
    xml_.open("worldbody");
    add_lights();
    for (std::size_t i = 0; i < count(); ++i) {
      if (!flat(i).X_WE) continue;
      if (floating_.contains(robot_of(i))) {
        losses_.entity(i, "MuJoCo attaches no model that has a floating joint; --form expand "
                          "writes it");
      } else if (robot_of(i) != nullptr) {
        attach(i);
      } else {
        add_solid(i);
      }
    }
    xml_.close();
    add_welds();
    if (has_keyframe_) {
      add_keyframes();
    } else {
      lose_pose_sets("MuJoCo counts the positions of floating and planar joints itself");
    }
    return finish();
  }

 private:
  const std::string& model_id(std::size_t i) const { return scene_.flat.models[*flat(i).model].id; }

  /// MuJoCo's reader of URDF removes the folders from mesh paths, and adds positions for floating
  /// and planar joints, so no keyframe fits.
  void check_models() {
    for (const LinkedModel& model : scene_.scene.models) {
      if (!model.robot) continue;
      for (const MeshReference& mesh : model.meshes) {
        if (mesh.is_texture || mesh.filename.find('/') == std::string::npos) continue;
        losses_.shape(mesh.span,
                      "the mesh `" + mesh.filename + "`, which MuJoCo looks for beside the URDF,");
      }
      for (const urdf::Joint& joint : model.robot->joints) {
        if (joint.has_one_axis() || joint.type == urdf::JointType::fixed) continue;
        if (joint.type == urdf::JointType::floating) {
          floating_.insert(&model);
          continue;
        }
        losses_.joint(joint, "what MuJoCo makes of it");
        has_keyframe_ = false;
      }
    }
    if (has_keyframe_) return;
    for (std::size_t i = 0; i < count(); ++i) {
      losses_.joint_pose(i, "MuJoCo counts the positions of floating and planar joints itself");
    }
  }

  void add_models() {
    std::unordered_set<std::size_t> used;
    for (std::size_t i = 0; i < count(); ++i) {
      if (floating_.contains(robot_of(i))) continue;
      if (robot_of(i) == nullptr || !flat(i).X_WE || !used.insert(*flat(i).model).second) continue;
      xml_.empty("model",
                 {{"name", model_id(i)}, {"file", scene_.flat.models[*flat(i).model].urdf}});
    }
  }

  void attach(std::size_t i) {
    const Pose& X_WE = *flat(i).X_WE;
    const bool is_fixed = flat(i).anchor.kind == Attachment::Kind::world;
    if (is_fixed) {
      xml_.open("frame", {{"pos", join_numbers(X_WE.position)},
                          {"quat", quaternion_text(X_WE.orientation)}});
    } else {
      xml_.open("body", {{"name", flat(i).path},
                         {"pos", join_numbers(X_WE.position)},
                         {"quat", quaternion_text(X_WE.orientation)}});
      add_free_joint(name(i, "free"), *flat(i).X_WE);
      if (flat(i).anchor.kind == Attachment::Kind::link) welded_.push_back(i);
    }
    xml_.empty("attach", {{"model", model_id(i)}, {"prefix", name(i, "")}});
    xml_.close();
    add_joint_positions(i);
  }

  /// Parents before children, and siblings in file order, as MuJoCo numbers its joints.
  void add_joint_positions(std::size_t i) {
    const LinkedModel& model = *robot_of(i);
    std::vector<std::size_t> open{to_size(model.tree.roots.front())};
    while (!open.empty()) {
      const std::size_t link = open.back();
      open.pop_back();
      if (const auto joint = model.tree.parent_joint[link]) {
        const urdf::Joint& parent = model.joint(*joint);
        if (parent.has_one_axis()) {
          keys_.add_position(i, parent, start_of(i, parent));
        }
      }
      const std::vector<JointIndex>& joints = model.tree.child_joints[link];
      for (std::size_t k = joints.size(); k-- > 0;) {
        open.push_back(to_size(*model.tree.joint_child[to_size(joints[k])]));
      }
    }
  }

  void add_welds() {
    if (welded_.empty()) return;
    xml_.open("equality");
    for (const std::size_t i : welded_) {
      const auto X_LE = pose_on_anchor(scene_, i, frames_);
      if (!X_LE) {
        losses_.anchor(i, "there is no link to attach it to");
        continue;
      }
      const FlatAttachment& anchor = flat(i).anchor;
      xml_.empty("weld", {{"body1", name(anchor.index, anchor.link)},
                          {"body2", flat(i).path},
                          {"relpose", join_numbers(X_LE->position) + " " +
                                          quaternion_text(X_LE->orientation)}});
    }
    xml_.close();
  }

  std::vector<std::size_t> welded_;
  std::unordered_set<const LinkedModel*> floating_;  ///< models with a floating joint
  bool has_keyframe_ = true;
};

}  // namespace

std::string write_attached(const SceneExport& scene) { return AttachWriter(scene).run(); }

}  // namespace smurf
