// SPDX-License-Identifier: BSD-3-Clause
// Models and scenes after linking: files found, sections merged, names resolved, frames composed.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/mesh.hpp"
#include "smurf/model.hpp"
#include "smurf/names.hpp"
#include "smurf/pose.hpp"
#include "smurf/scene.hpp"
#include "smurf/source.hpp"
#include "smurf/urdf.hpp"
#include "smurf/xml.hpp"

namespace smurf {

class UserSchemas;

enum class LinkIndex : std::uint32_t {};
enum class JointIndex : std::uint32_t {};
enum class ModelIndex : std::uint32_t {};
enum class SceneIndex : std::uint32_t {};
enum class UseIndex : std::uint32_t {};
enum class InstanceIndex : std::uint32_t {};
enum class JointPoseIndex : std::uint32_t {};

template <class Index>
std::size_t to_size(Index index) {
  return static_cast<std::size_t>(index);
}

/// The tree of links and joints. Parts without meaning are empty: a joint with an unknown link has
/// no ends. A link with two parents keeps the first.
struct KinematicTree {
  std::vector<std::optional<LinkIndex>> joint_parent, joint_child;  ///< by joint
  std::vector<std::optional<JointIndex>> parent_joint;              ///< by link
  std::vector<std::vector<JointIndex>> child_joints;                ///< by link
  std::vector<LinkIndex> roots;                                     ///< links without parent joint
  std::vector<LinkIndex> order;  ///< reachable from the roots, parents before children
};

/// Names of one kind. Of equal names, the first is found. Views point into the model.
class NameTable {
 public:
  /// The index of an earlier equal name; none if the name is new.
  std::optional<std::uint32_t> add(std::string_view name, std::uint32_t index);
  /// Reserves memory for this number of names.
  void reserve(std::size_t count);
  std::optional<std::uint32_t> find(std::string_view name) const;
  bool contains(std::string_view name) const { return find(name).has_value(); }
  const std::vector<std::string_view>& names() const { return names_; }  ///< unique, in order

 private:
  /// The slot that contains the name, or the empty slot for it.
  std::size_t slot_of(std::string_view name) const;
  void rehash(std::size_t slots);

  // Open addressing: robots have tens of thousands of names, and one node each would use more
  // memory than everything else here.
  std::vector<std::string_view> names_;
  std::vector<std::uint32_t> indices_;  ///< of names_
  std::vector<std::uint32_t> slots_;    ///< positions in names_, from 1; 0 is an empty slot
};

/// A path in a URDF and the files that readers find for it: URDF readers relative to the folder of
/// the URDF, MARS relative to the folder of the .smurf.
struct MeshReference {
  Span span;
  std::string filename;  ///< as written
  bool is_texture = false;

  std::string path;     ///< resolved; empty when it cannot be (unknown package, other scheme)
  bool exists = false;  ///< also true outside of the project, where files are not looked up
  /// Whether the folder of the URDF has a file of its name, whatever folder is written before it.
  bool lies_beside = false;
  /// If there is no file at `path`: a file whose path differs only in case or in `/` for `\`.
  std::string similar;
  /// If that does not exist either: the path that was probably meant, to a file with a similar name
  /// in the same folder, or to the file that the path leads to from a folder above the URDF. If the
  /// file exists, but is not named by an address: package://NAME/REST, where it is in a package.
  std::string meant;
  /// Whether no package is known by the name in a package://NAME/REST, and the file was found in a
  /// folder above the URDF.
  bool is_package_guessed = false;
  /// Whether the package was found elsewhere: the folder of the URDF and the four above it have no
  /// file NAME/REST.
  bool is_package_elsewhere = false;
  std::string package_there;  ///< if it was guessed: the name in the package.xml of that folder, if
                              ///< it has one
  const MeshFile* file = nullptr;  ///< facts about the mesh at `path`; null if it was not opened

  /// The file that MARS opens: the .bobj of this mesh where there is one (smurf.cpp:1070-1111).
  /// Empty for a URDF without .smurf, and for addresses, which MARS does not understand.
  std::string mars_path;
  bool mars_exists = false;
  const MeshFile* mars_file = nullptr;
};

/// An image that an annotation names, relative to the .smurf (MARS MaterialData.cpp:112-115).
struct TextureReference {
  Span span;
  std::string filename;  ///< as written
  std::string path;      ///< resolved
  bool exists = false;
  bool is_denied = false;  ///< it is outside of the project, and may exist or not
};

/// The place of a visual in a robot.
struct VisualIndex {
  std::uint32_t link = 0, visual = 0;  ///< indices in Robot::links and Link::visuals
};

/// A file of a model and its parsed content.
struct ModelFile {
  enum class Kind : std::uint8_t { main, urdf, annotation };
  Kind kind = Kind::annotation;
  SourceId source{};
  std::optional<yaml::Document> document;  ///< main and annotation files that are YAML
};

/// A loaded model: its URDF, its annotations, and what their names mean. Views inside (names, XML,
/// YAML) point into the SourceMap and into the vectors here, so the model is moved, not copied.
struct LinkedModel {
  std::string path;       ///< as given: a .smurf, a .urdf or an annotation file
  bool has_main = false;  ///< false for a URDF or annotation file without a main file
  Model main;
  std::vector<ModelFile> files;  ///< in the order they were read
  Annotations annotations;       ///< of all files, merged
  std::optional<urdf::Robot> robot;
  std::string urdf_path;               ///< empty if there is no URDF
  Language language = Language::urdf;  ///< of that file
  KinematicTree tree;
  /// Names of links that must not touch each other: said by the file of another language that the
  /// robot was made from. A URDF has an SRDF for them.
  std::vector<std::pair<std::string, std::string>> excluded;
  NameTable link_names, joint_names, visual_names, collision_names, material_names;
  /// The indices in material_names are those of Robot::materials and continue with these.
  std::vector<VisualIndex> visual_materials;
  NameTable motor_names, sensor_names;
  std::vector<MeshReference> meshes;  ///< of the URDF, in document order
  std::vector<TextureReference> annotation_textures;
  /// Annotation files beside the main file, named like its own, that `files` does not list.
  std::vector<std::string> unlisted_files;
  /// Paths of mesh files beside those of the robot that nothing in its package names.
  std::vector<std::string> unused_meshes;
  const UserSchemas* schemas = nullptr;  ///< the schemas that were used for loading; may be null
  /// False when a file is missing or broken: names that seem unknown may be in it.
  bool is_complete = true;

  LinkedModel() = default;
  LinkedModel(LinkedModel&&) = default;
  LinkedModel& operator=(LinkedModel&&) = default;
  LinkedModel(const LinkedModel&) = delete;
  LinkedModel& operator=(const LinkedModel&) = delete;

  const urdf::Link& link(LinkIndex index) const { return robot->links[to_size(index)]; }
  const urdf::Joint& joint(JointIndex index) const { return robot->joints[to_size(index)]; }
  /// The first link of this name; null if there is none. Valid as long as the model.
  const urdf::Link* find_link(std::string_view name) const;
  const urdf::Joint* find_joint(std::string_view name) const;
  const Motor* find_motor(std::string_view name) const;
  const Sensor* find_sensor(std::string_view name) const;
  /// The link as an index of the tree and of forward_kinematics().
  std::optional<LinkIndex> link_index(std::string_view name) const;
  std::optional<JointIndex> joint_index(std::string_view name) const;

  /// The YAML document that contains a span; null for XML and unread files.
  const yaml::Document* document(SourceId source) const;
  /// The table of a kind; null for kinds without one.
  const NameTable* names(NameKind kind) const;
};

/// Joint positions by joint name; rad or m.
using JointPositions = std::map<std::string, double, std::less<>>;

/// Poses X_RL of every link in the frame of the (first) root link, by LinkIndex; links that the
/// root does not reach have none. Joints not listed are at zero; mimic joints follow their leader.
std::vector<std::optional<Pose>> forward_kinematics(const LinkedModel& model,
                                                    const JointPositions& positions);

/// Positions of a named joint pose set; pose keys name motors or joints. None if there is no set of
/// that name.
std::optional<JointPositions> joint_positions(const LinkedModel& model, std::string_view pose_name);

/// The thing that an instance is fixed to, or placed relative to.
struct Attachment {
  enum class Kind : std::uint8_t { none, world, link };
  Kind kind = Kind::none;
  InstanceIndex instance{};  ///< kind link
  std::string link;          ///< kind link

  friend bool operator==(const Attachment&, const Attachment&) = default;
};

/// The placement of an entity, including the scenes that contain it.
struct Placement {
  Attachment parent;  ///< the frame of X_PE; none: the world
  Attachment anchor;
  /// The own pose, composed with those of the includes up to the include that gives the parent.
  Pose X_PE;
  bool is_known = true;  ///< false when a parent or a pose is unreadable
};

/// A scene file, read once however often it is included.
struct SceneFile {
  std::string path;
  SourceId source{};
  std::optional<yaml::Document> document;  ///< for a drawing (.svg): the scene that it describes
  std::optional<xml::Document> drawing;
  Scene scene;
};

/// A YAML file of an entity with a custom type: its contents are sections.
struct DataFile {
  SourceId source{};
  yaml::Document document;
};

/// One use of a scene file: the scene that was loaded, or an include.
struct SceneUse {
  SceneIndex scene{};
  std::string path;                  ///< "outer/inner"; empty for the loaded scene
  std::optional<UseIndex> outer;     ///< none for the loaded scene
  std::size_t including_entity = 0;  ///< in the scene of `outer`
  Placement placement;               ///< inherited by its entities without a parent
};

/// An entity after nested scenes are expanded.
struct Instance {
  std::string name;  ///< as written; empty when there is none
  std::string path;  ///< unique: "outer/inner"
  UseIndex use{};
  std::size_t entity = 0;  ///< in the scene of `use`
  std::string type;        ///< as written, else the extension of the file
  std::string file;        ///< resolved; empty when there is none
  std::optional<ModelIndex> model;
  Placement placement;
  JointPoseIndex joint_pose{};  ///< index for LinkedScene::joint_positions()
  /// World pose of the root link frame; absent when something it depends on is in error.
  std::optional<Pose> X_WE;
};

/// A loaded scene. A .smurf or .urdf is loaded as a scene of one entity, whose scene file has no
/// document.
struct LinkedScene {
  std::string path;
  std::vector<SceneFile> scenes;     ///< the loaded one first
  std::vector<SceneUse> uses;        ///< the loaded scene first, outer uses before inner ones
  std::vector<LinkedModel> models;   ///< each file once
  std::vector<Instance> instances;   ///< depth-first, in file order
  std::vector<DataFile> data_files;  ///< each model once
  /// The distinct joint poses of the instances; in the first, all joints are at zero.
  std::vector<JointPositions> joint_poses{1};
  const UserSchemas* schemas = nullptr;  ///< the schemas that were used for loading; may be null
  bool is_complete = true;               ///< false when a file is missing or broken

  LinkedScene() = default;
  LinkedScene(LinkedScene&&) = default;
  LinkedScene& operator=(LinkedScene&&) = default;
  LinkedScene(const LinkedScene&) = delete;
  LinkedScene& operator=(const LinkedScene&) = delete;

  const SceneUse& use(const Instance& instance) const { return uses[to_size(instance.use)]; }
  const SceneFile& file(const SceneUse& use) const { return scenes[to_size(use.scene)]; }
  const Entity& entity(const Instance& instance) const {
    return file(use(instance)).scene.entities[instance.entity];
  }
  /// The entity that includes a scene; null for the loaded scene.
  const Entity* entity(const SceneUse& use) const {
    return use.outer ? &file(uses[to_size(*use.outer)]).scene.entities[use.including_entity]
                     : nullptr;
  }
  const Instance& instance(InstanceIndex index) const { return instances[to_size(index)]; }
  /// The positions of all joints that do not mimic another joint.
  const JointPositions& joint_positions(const Instance& instance) const {
    return joint_poses[to_size(instance.joint_pose)];
  }
  const LinkedModel* model(const Instance& instance) const {
    return instance.model ? &models[to_size(*instance.model)] : nullptr;
  }
};

}  // namespace smurf
