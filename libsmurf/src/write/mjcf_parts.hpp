// SPDX-License-Identifier: BSD-3-Clause
// What both forms of a MuJoCo world have in common: settings, lights, and what is no model.
#pragma once

#include <set>
#include <string>

#include "write/scene_losses.hpp"
#include "write/scene_parts.hpp"
#include "write/xml_text.hpp"

namespace smurf {

std::string quaternion_text(const Quaternion& q);
/// R I R^T in MuJoCo's order: MuJoCo takes no orientation together with a full tensor.
std::string full_inertia(const LinkInertial& mass);

class MjcfParts {
 public:
  explicit MjcfParts(const SceneExport& scene) : scene_(scene), losses_(scene, "MJCF") {}

 protected:
  const FlatInstance& flat(std::size_t i) const { return scene_.flat.instances[i]; }
  const Instance& linked(std::size_t i) const { return scene_.scene.instances[i]; }
  std::size_t count() const { return scene_.flat.instances.size(); }
  const LinkedModel* robot_of(std::size_t i) const { return smurf::robot_of(scene_.scene, i); }
  /// Of a body or joint: "cell/Table/top".
  std::string name(std::size_t i, std::string_view part) const {
    return flat(i).path + "/" + std::string(part);
  }

  void add_settings();
  /// Inside <asset>: only what MuJoCo can read.
  void add_heightmaps();
  void add_lights();
  /// What is no model: its shapes, or its loss.
  void add_solid(std::size_t i);
  /// A shape that is no mesh; others are left out.
  void add_geom(const std::string& geom_class, const Pose& pose, const FlatGeometry& geometry,
                const std::optional<Rgba>& color);
  /// The joint of a body that nothing holds. Not <freejoint/>, which DART takes for a weld.
  void add_free_joint(std::size_t i);
  /// The positions of the next joint, in the order in which joints are written.
  void add_start(const std::string& numbers) { start_ += (start_.empty() ? "" : " ") + numbers; }
  /// One keyframe `initial` with all of these.
  void add_keyframe();
  /// Losses of the world and of annotations, and the end.
  std::string finish();

  const SceneExport& scene_;
  SceneLosses losses_;
  LinkFrames frames_;
  XmlText xml_;
  std::string start_;  ///< qpos

 private:
  std::set<std::size_t> heightmaps_;  ///< instances whose hfield is declared
};

}  // namespace smurf
