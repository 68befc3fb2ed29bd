// SPDX-License-Identifier: BSD-3-Clause
// Flat scenes as text in the formats of other programs.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {

/// How a format refers to models: by file name, or by writing them out.
enum class SceneForm : std::uint8_t { reference, expand };

/// The source of the meshes and textures of a preview. Files are relative to the output's folder.
struct MeshSource {
  /// Reads a mesh; null if there are no meshes. A writer calls it once for each file and kind,
  /// because the result is not cached.
  std::function<MeshTriangles(const std::string& file, TexturePoints texture_points)> triangles;
  /// A key that is equal for all file names with the same triangles.
  std::function<std::string(const std::string& file)> identity;
  /// Null if images are not available.
  std::function<FileContent(const std::string& file)> image;
  std::uint64_t most_bytes = Limits{}.scene_bytes;    ///< limit for all meshes, and for all images
  std::uint64_t most_pixels = Limits{}.image_pixels;  ///< of all images
};

/// What a motor is commanded with. Automatic: a position, unless the model says a speed; a joint
/// without a motor gets one, unless the motors are as written.
enum class MotorKind : std::uint8_t { as_written, automatic, position, velocity, effort };
/// A number for some joints.
struct JointNumber {
  std::string joints;  ///< a pattern of names with `*`; "": all joints
  double value = 0;
};
/// How a controller of ros2_control commands a joint.
struct ControlledJoint {
  /// Position, velocity or effort. An effort that follows the error of a position or speed is a
  /// motor of that, with the gains.
  MotorKind kind = MotorKind::position;
  std::optional<double> kp;  ///< N m/rad or N/m
  std::optional<double> kv;  ///< N m s/rad or N s/m
  std::string controller;
  std::string file;  ///< that states it, as in messages
};
/// By the names of joints.
using ControlledJoints = std::map<std::string, ControlledJoint, std::less<>>;

/// Motors of formats that have them. Of several numbers for one joint, the last one counts.
struct MotorOptions {
  MotorKind kind = MotorKind::as_written;
  std::vector<JointNumber> kp;        ///< stiffness of positions, N m/rad or N/m
  std::vector<JointNumber> kv;        ///< damping, N m s/rad or N s/m
  std::vector<JointNumber> armature;  ///< inertia of the motor at its joint, kg m^2 or kg
  /// What the controllers of models say, which these options override.
  std::map<const LinkedModel*, ControlledJoints> controlled = {};
};

/// What of a robot can touch itself. As usual: SceneFormat::usual_contacts.
enum class SelfCollision : std::uint8_t { as_usual, none, neighbours, srdf, all };
/// Links of one model that must not touch, as indices.
using LinkPairs = std::vector<std::pair<std::size_t, std::size_t>>;
/// Contacts within the robots of a scene.
struct OwnContacts {
  SelfCollision choice = SelfCollision::as_usual;
  std::map<const LinkedModel*, LinkPairs> left_out;  ///< sorted pairs, the smaller index first
};

struct ChosenMass;
/// The masses of links whose shapes were replaced: those that they have with the shapes before.
using KeptMasses = std::map<const urdf::Link*, ChosenMass>;

/// Joint positions of a robot and their names, such as the group states of an SRDF.
using NamedPositions = std::vector<std::pair<std::string, JointPositions>>;

/// The input of a writer. All of it must outlive the call.
struct SceneExport {
  const FlatScene& flat;
  const LinkedScene& scene;  ///< the source of `flat`
  const SourceMap& sources;  ///< the source files of `scene`
  DiagnosticSink& losses;    ///< receives findings about losses (SML82xx)
  bool links = false;        ///< write the world poses of all links, if the format supports them
  SceneForm form = SceneForm::expand;
  bool ground = false;  ///< add a floor at z = 0; SceneFormat::has_ground
  MotorOptions motors = {};
  OwnContacts contacts = {};
  std::map<const LinkedModel*, NamedPositions> group_states = {};
  const KeptMasses* kept_masses = nullptr;  ///< null: no shapes were replaced
  bool names_copies = false;                ///< model files in `flat` are copies that will be made
  MeshSource meshes = {};                   ///< for previews; without it, meshes are lost
  /// Limit of the text. A longer text is of no use and may end anywhere.
  std::uint64_t most_bytes = Limits{}.scene_bytes;

  /// The positions of all joints of an instance that do not mimic another joint.
  const JointPositions& joint_positions(std::size_t instance) const {
    return flat.joint_poses[to_size(flat.instances[instance].joint_pose)];
  }
};

/// A format is one file in src/write that defines one of these, and its line in
/// src/write/scene_formats.def.
struct SceneFormat {
  std::string_view name;  ///< of --format
  std::string_view help;
  /// Omits instances without a pose, which occur only in scenes with errors.
  std::string (*write)(const SceneExport& scene) = nullptr;
  /// What the reader needs besides the file, for people; FOLDER stands for the folder of the file.
  std::string_view remark = {};
  /// The program that loads the files which the reference form names; null: not judged.
  const Reader* reader = nullptr;
  bool has_reference_form = false;
  bool has_expanded_form = true;
  bool has_ground = false;        ///< can add a floor to the expanded form
  bool repeats_models = false;    ///< writes the model of each instance out
  bool has_motors = false;        ///< writes MotorOptions
  bool has_armatures = false;     ///< writes MotorOptions::armature
  bool has_contacts = false;      ///< writes OwnContacts::choice
  bool has_link_pairs = false;    ///< writes OwnContacts::left_out
  bool loses_link_pairs = false;  ///< its readers compute contacts, and it has no place for pairs
  bool has_bitmasks = false;      ///< writes the bitmasks of collisions
  bool has_neighbours = false;    ///< links can touch that a joint connects
  bool welds_links = false;       ///< its readers keep neighbours of links on fixed joints apart
  /// What of a robot can touch itself if nobody chooses. As usual: what the model says.
  SelfCollision usual_contacts = SelfCollision::as_usual;
  bool has_collisions = false;     ///< writes the collisions of links
  bool has_meshes_inside = false;  ///< contains the triangles of meshes, and names no files of them
  bool fixes_world_roots = false;  ///< its readers know that a root named `world` does not move
  /// The parts that check_scene_size() counts in advance; null if nothing is repeated.
  RepeatedParts (*repeated_parts)(const LinkedModel& model) = nullptr;
  /// Why this build cannot write it, and what to do; empty if it can. Null: every build can.
  std::string_view (*obstacle)() = nullptr;
};

/// What becomes of models that the scene anchors nowhere. Readers of URDFs fix a root named
/// `world`; MARS lets every such model move freely.
enum class BaseChoice : std::uint8_t { world_roots_fixed, fixed, floating };
/// Anchors these models to the world. `anchor: none` in the scene is kept.
void anchor_bases(FlatScene& flat, const LinkedScene& scene, BaseChoice choice);

/// A model of which a part is below the floor of SceneExport::ground at the start.
struct BelowFloor {
  std::size_t instance = 0;
  double depth = 0;  ///< m
};
/// Considers the collisions of links that can move; the visuals of models without collisions.
/// Ignores meshes that cannot be read, and depths below a millimetre.
std::vector<BelowFloor> below_floor(const SceneExport& scene);

std::span<const SceneFormat* const> scene_formats();
/// Null if there is no format of that name.
const SceneFormat* find_scene_format(std::string_view name);

/// A page of the format html that shows two versions of a scene together. Both were flattened for
/// the same folder; meshes and limits are those of `after`. Empty if the page would be too large,
/// or in a build without the viewer.
std::string write_both_versions(const SceneExport& before, const SceneExport& after);

}  // namespace smurf
