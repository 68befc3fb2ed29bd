// SPDX-License-Identifier: BSD-3-Clause
// Drake model directives. Rotations are an angle and an axis, since Drake reads no quaternions
// (common/schema/rotation.h).
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "write/json_text.hpp"
#include "write/scene_losses.hpp"
#include "write/scene_parts.hpp"

namespace smurf {
namespace {

/// A flow scalar that YAML and Drake read as this text.
std::string quoted(std::string_view text) {
  std::string quoted;
  append_json(quoted, text);
  return quoted;
}

std::string list(const Vector3& v) {
  return "[" + format_number(v[0]) + ", " + format_number(v[1]) + ", " + format_number(v[2]) + "]";
}

std::string rotation(const Quaternion& q) {
  const double sine = std::hypot(q.x, q.y, q.z);
  if (sine == 0) return "!Identity {}";
  const double degrees = 2 * std::atan2(sine, q.w) * 180 / std::numbers::pi;
  return "!AngleAxis {angle_deg: " + format_number(degrees) +
         ", axis: " + list({q.x / sine, q.y / sine, q.z / sine}) + "}";
}

class DirectivesWriter {
 public:
  explicit DirectivesWriter(const SceneExport& scene)
      : scene_(scene), losses_(scene, "Drake directives"), names_(safe_names(scene.flat)) {}

  std::string run() {
    out_ = "# A package.xml beside this file names the package `scene`.\ndirectives:\n";
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (!flat(i).X_WE) continue;
      if (robot_of(i) != nullptr) {
        add_model(i);
      } else {
        losses_.entity(i, "directives add model files only");
      }
    }
    // A weld names two models, which both have to be there by then.
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (flat(i).X_WE && robot_of(i) != nullptr) add_weld(i);
    }
    using enum SceneLosses::World;
    losses_.world({gravity, step_size, solver, environment, lights});
    losses_.annotations_and_properties();
    losses_.files_in_archives();
    return std::move(out_);
  }

 private:
  const FlatInstance& flat(std::size_t i) const { return scene_.flat.instances[i]; }
  const LinkedModel* robot_of(std::size_t i) const { return smurf::robot_of(scene_.scene, i); }
  std::string root_name(std::size_t i) const { return root_link_name(*robot_of(i)); }

  void add_pose(const Pose& pose, std::string_view indent) {
    out_ += std::string(indent) + "translation: " + list(pose.position) + "\n" +
            std::string(indent) + "rotation: " + rotation(pose.orientation) + "\n";
  }

  void add_model(std::size_t i) {
    out_ += "- add_model:\n    name: " + quoted(names_[i]) +
            "\n    file: " + quoted("package://scene/" + scene_.flat.models[*flat(i).model].urdf) +
            "\n";
    if (!flat(i).joint_positions.empty()) {
      out_ += "    default_joint_positions:\n";
      for (const auto& [joint, position] : flat(i).joint_positions) {
        out_ += "      " + quoted(joint) + ": [" + format_number(position) + "]\n";
      }
    }
    if (flat(i).anchor.kind != Attachment::Kind::none) return;
    out_ += "    default_free_body_pose:\n      " + quoted(root_name(i)) + ":\n";
    add_pose(*flat(i).X_WE, "        ");
  }

  void add_weld(std::size_t i) {
    const FlatAttachment& anchor = flat(i).anchor;
    if (anchor.kind == Attachment::Kind::none) return;
    std::string parent = "world";
    Pose X_PC = *flat(i).X_WE;
    if (anchor.kind == Attachment::Kind::link) {
      const std::size_t other = to_size(scene_.scene.instances[i].placement.anchor.instance);
      const std::optional<Pose> X_LE = pose_on_anchor(scene_.scene, i, frames_);
      if (!X_LE) {
        return losses_.anchor(i, "`" + flat(other).path + "` is no model with links");
      }
      parent = names_[other] + "::" + anchor.link;
      X_PC = *X_LE;
    }
    out_ += "- add_weld:\n    parent: " + quoted(parent) +
            "\n    child: " + quoted(names_[i] + "::" + root_name(i)) + "\n    X_PC:\n";
    add_pose(X_PC, "      ");
  }

  const SceneExport& scene_;
  SceneLosses losses_;
  std::vector<std::string> names_;
  LinkFrames frames_;
  std::string out_;
};

}  // namespace

extern constinit const SceneFormat scene_dmd{
    .name = "dmd",
    .help = "Drake model directives",
    .write = [](const SceneExport& scene) { return DirectivesWriter(scene).run(); },
    .has_reference_form = true,
    .has_expanded_form = false};

}  // namespace smurf
