// SPDX-License-Identifier: BSD-3-Clause
// Common parts of both forms of a MuJoCo world: settings, lights, and all that is not a model.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/unique_names.hpp"
#include "write/losses/scene_losses.hpp"
#include "write/mjcf/mjcf_keys.hpp"
#include "write/mjcf/mjcf_meshes.hpp"
#include "write/parts/contacts.hpp"
#include "write/parts/gazebo_elements.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/text/xml_text.hpp"

namespace smurf {

std::string quaternion_text(const Quaternion& q);

class MjcfParts {
 public:
  explicit MjcfParts(const SceneExport& scene);

 protected:
  const FlatInstance& flat(std::size_t i) const { return scene_.flat.instances[i]; }
  std::size_t count() const { return scene_.flat.instances.size(); }
  const LinkedModel* robot_of(std::size_t i) const { return smurf::robot_of(scene_.scene, i); }
  /// The name of a body or joint in the result: "cell/Table/top".
  std::string name(std::size_t i, std::string_view part) const {
    return flat(i).path + "/" + std::string(part);
  }

  void add_settings();
  /// Inside <asset>: only files that MuJoCo can read.
  void add_heightmaps();
  void add_lights();
  /// Writes the shapes of an entity that is not a model, or reports its loss.
  void add_solid(std::size_t i);
  /// Class, type and size of a geom; none if MuJoCo has no such geom.
  std::optional<std::vector<XmlText::Attribute>> geom_of(const std::string& geom_class,
                                                         const FlatGeometry& geometry) const;
  /// Writes a geom. `geom` contains the attributes from geom_of() and any others.
  void add_geom(std::vector<XmlText::Attribute> geom, const Pose& pose,
                const std::optional<Rgba>& color, const Contacts& contacts);
  /// Writes the inertial of a body. `moves`: the body has a joint. Reports losses at `span`.
  void add_inertial(const LinkInertial& mass, bool moves, Span span, const std::string& name);
  /// Writes the meshes of entities that are not models into <asset>.
  void add_meshes_of_entities();
  /// Whether the content of a file is PNG; MuJoCo refuses the whole world for one that is not.
  bool is_png(const std::string& file) const;
  /// Why MuJoCo cannot read a heightmap; empty if it can.
  std::string fault_of_heightmap(const std::string& file) const;
  /// The joint of a free body. Not <freejoint/>, which DART reads as a weld.
  void add_free_joint(const std::string& name, const Pose& X_WB);
  /// The spring that `<gazebo>` gives a joint; null if there is none.
  const JointSpring* spring_of(const LinkedModel& model, const urdf::Joint& joint);
  /// The armature that annotations give a joint; kg m^2 or kg, 0 without one.
  double armature_of(const LinkedModel& model, const urdf::Joint& joint);
  /// The start position of a joint. With automatic motors, which would have to hold it, a joint
  /// whose zero is out of its limits starts at the nearest one, unless the scene says where.
  double start_of(std::size_t instance, const urdf::Joint& joint);
  /// The keyframes: the start, and the joint pose sets of the robots.
  void add_keyframes();
  /// Reports the pose sets as lost.
  void lose_pose_sets(std::string_view why);
  /// Losses of the world and of annotations, and the end.
  std::string finish();

  const SceneExport& scene_;
  SceneLosses losses_;
  LinkFrames frames_;
  XmlText xml_{scene_.most_bytes};
  UniqueNames geom_names_;
  MjcfKeys keys_;
  MjcfMeshes meshes_;

 private:
  void add_class(const std::string& name, const std::vector<XmlText::Attribute>& geom);
  bool has_bitmasks_ = false;
  std::map<const LinkedModel*, std::map<std::string_view, JointSpring>> springs_;
  std::map<const LinkedModel*, std::map<std::string_view, double>> armatures_;
  std::map<std::pair<const LinkedModel*, JointPoseIndex>, JointPositions> starts_;

  /// How many joint pose sets and group states a robot has.
  std::size_t pose_sets_of(const LinkedModel& model) const;
  void append_pose_sets(std::size_t i, std::vector<MjcfKeys::Posed>& sets) const;
  /// The positions that joints get, of which a few are given.
  JointPositions held(const LinkedModel& model, JointPositions given) const;

  struct DeclaredHeights {
    std::string name;
    double lift = 0;  ///< the height of the darkest pixel, m
  };
  void declare_heights(std::size_t instance, const FlatShape& shape, const FlatHeightmap& map);
  std::map<const FlatShape*, DeclaredHeights> heightmaps_;
};

}  // namespace smurf
