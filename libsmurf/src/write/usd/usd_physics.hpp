// SPDX-License-Identifier: BSD-3-Clause
// The physics of a stage: UsdPhysics, and schemas of PhysX that Isaac Sim reads for what
// UsdPhysics cannot express (PhysxJointAPI, PhysxMimicJointAPI, PhysicsJointStateAPI).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "write/losses/scene_losses.hpp"
#include "write/parts/joint_drives.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/usd/usd_layout.hpp"
#include "write/usd/usda_text.hpp"

namespace smurf {

class UsdPhysics {
 public:
  /// `names` contains the name of each instance's prim. The arguments must outlive this object.
  UsdPhysics(const SceneExport& scene, const std::vector<std::string>& names, SceneLosses& losses,
             UsdaText& text)
      : scene_(scene), names_(names), losses_(losses), text_(text) {}

  void add_scene();
  /// The instance must have a robot.
  const UsdLayout& layout_of(std::size_t instance) { return model_of(instance).layout; }
  /// Schemas for the Xform of an instance with a robot.
  std::vector<std::string> schemas_of_robot(std::size_t instance);
  /// The attributes of these schemas.
  void add_articulation(std::size_t instance);
  /// Whether an instance without a robot is a body.
  bool is_body(std::size_t instance) const;
  /// Writes the mass of a link, or of an instance without a robot.
  void add_mass(std::size_t instance, std::size_t link);
  void add_mass(std::size_t instance);
  /// Whether links of one robot can touch each other.
  bool has_own_contacts() const {
    return scene_.contacts.choice != SelfCollision::as_usual &&
           scene_.contacts.choice != SelfCollision::none;
  }
  /// Writes a scope with the joints between the bodies of an instance and the joint of its anchor.
  void add_joints(std::size_t instance, LinkFrames& frames);

 private:
  /// A joint between two links that are bodies.
  struct Joint {
    const urdf::Joint* urdf = nullptr;
    std::size_t body0 = 0, body1 = 0;
    Pose X_0J;  ///< pose of the joint in body0; the frame of body1 is at the joint
    std::string name;
  };
  /// All instances of a model share this.
  struct Model {
    UsdLayout layout;
    std::vector<Joint> joints;
    std::map<const urdf::Joint*, std::size_t> index;  ///< in `joints`
    std::string anchor;                               ///< name of the joint to the anchor
    std::string own_collisions;                       ///< name of its collision group
    std::map<const urdf::Joint*, JointDrive> drives;
    std::map<const urdf::Joint*, DrivenFollower> followers;
  };
  struct Ends {
    std::string body0;  ///< path of its prim; "": the world
    Pose X_0J;
    std::string body1;
    Pose X_1J = {};
  };

  const LinkedModel& robot(std::size_t instance) const { return *robot_of(scene_.scene, instance); }
  std::string path(std::size_t instance) const { return "/World/" + names_[instance]; }
  std::string path(std::size_t instance, std::size_t link) {
    return path(instance) + "/" + layout_of(instance).links[link]->path;
  }
  const Model& model_of(std::size_t instance);
  /// The number of robots with joints among the instances that are fixed to each other.
  std::size_t robots_with_joints(std::size_t instance);
  void find_bases();
  /// The link of another instance to which the body of this one is fixed; null if there is none.
  const UsdLink* carrying_link(std::size_t instance);
  /// Instances that are fixed to each other are one articulation, that of the instance that carries
  /// the others: PhysX and Newton put articulations together from all bodies that joints connect,
  /// and a body can be in one only.
  bool is_articulation(std::size_t instance);
  void add_own_collisions(std::size_t instance);
  double start_of(std::size_t instance, const urdf::Joint& joint) const;
  static void find_joints(const LinkedModel& robot, Model& model);
  static void find_followers(const LinkedModel& robot, Model& model);
  void write_mass(const LinkInertial& mass, Span span, const std::string& name);
  void open_joint(std::string_view type, const std::string& name,
                  const std::vector<std::string>& schemas, const Ends& ends);
  std::optional<Ends> anchor_of(std::size_t instance, LinkFrames& frames);
  void add_anchor(std::size_t instance, LinkFrames& frames, const std::string& name);
  void add_joint(std::size_t instance, const Joint& joint);
  void add_axis(std::size_t instance, const Joint& joint, Ends ends);
  void add_limits(const urdf::Joint& joint, const std::optional<DrivenFollower>& follower);
  void add_drive(std::size_t instance, const urdf::Joint& joint, const JointDrive* drive);
  void add_leader(std::size_t instance, const DrivenFollower& follower);
  void add_locked(const Joint& joint, Ends ends);
  std::optional<DrivenFollower> leader_of(const Model& model, const urdf::Joint& joint);
  void number(const std::string& name, double value);

  const SceneExport& scene_;
  const std::vector<std::string>& names_;
  SceneLosses& losses_;
  UsdaText& text_;
  std::map<const LinkedModel*, Model> models_;
  std::vector<std::size_t> bases_;  ///< of each instance, the one that carries it in the end
  std::vector<std::size_t> robots_with_joints_;  ///< by the base
  std::set<const urdf::Joint*> reported_;
};

}  // namespace smurf
