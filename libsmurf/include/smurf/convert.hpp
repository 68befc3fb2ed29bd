// SPDX-License-Identifier: BSD-3-Clause
// Converts SMURF models to plain URDF and back, and proves that the result is the same robot.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"
#include "smurf/new_model.hpp"

namespace smurf {

/// How to write the paths of meshes and textures.
enum class MeshUri : std::uint8_t {
  rebase,    ///< relative paths resolve from the output folder; others stay
  relative,  ///< all paths of existing files become relative
  package,   ///< package://NAME/...
  absolute,
  file,  ///< file:///...
  keep   ///< unchanged
};

enum class BaseJoint : std::uint8_t { as_is, fixed, floating };

/// The elements of URDF that describe motors.
enum class Actuation : std::uint8_t { none, ros2_control, transmission };

/// The values of annotations that replace those of the URDF.
struct AppliedAnnotations {
  bool materials = false;  ///< colours, and textures where the URDF has none
  bool limits = false;     ///< of motors
  bool dynamics = false;   ///< of joints
  bool mimic = false;      ///< of motors
};

/// The options of export_urdf().
struct UrdfExport {
  /// Folder the URDF is written to; mesh and texture paths are re-based so that they resolve there.
  std::string output_folder = ".";
  /// Absolute path that relative paths start from; "": the current folder of the process.
  std::string current_folder = {};
  MeshUri mesh_uri = MeshUri::rebase;
  std::string package_name{}, package_folder{};  ///< for MeshUri::package; the folder is absolute
  /// Copies that the result names instead of meshes: relative to the output folder, by
  /// MeshReference::path.
  std::map<std::string, std::string> mesh_copies{};
  AppliedAnnotations apply{};
  Actuation actuation = Actuation::none;
  bool adds_gazebo_sensors = false;
  bool adds_mujoco_settings = false;  ///< settings that MuJoCo needs to find meshes
  bool has_srdf = false;              ///< an SRDF is also written; it contains poses and bitmasks
  bool strips_extensions = false;     ///< elements that URDF does not define
  bool strips_comments = false;
  bool collapses_fixed = false;
  std::vector<std::string> keep{};  ///< links and joints that are kept
  std::string prefix{};             ///< of names
  BaseJoint base = BaseJoint::as_is;
  std::string version{};  ///< version written into the URDF; empty: unchanged
  bool is_canonical = false;
};

/// The model's URDF, byte for byte except for relative mesh and texture paths that would not
/// resolve from the output folder, for characters that strict readers of XML refuse, and for the
/// changes that the options request. Reports ambiguous values (SML8003). Preconditions: model.robot
/// is set; with a base, the tree has one root and no link is called `world`.
std::string export_urdf(const LinkedModel& model, const SourceMap& sources,
                        const UrdfExport& options, DiagnosticSink& sink);

/// Why readers of strict XML refuse an exported URDF, read as `result`; empty if they accept it.
/// Precondition: result.robot is set.
std::string why_strict_readers_refuse(const LinkedModel& result, std::string_view urdf);

/// An SRDF beside the URDF. Joint pose sets become group states. Neighbouring links, and links
/// whose bitmasks share no bit, become pairs that do not collide. Precondition: model.robot is set.
/// None if the result would have more than `most` bytes.
std::optional<std::string> export_srdf(const LinkedModel& model, const std::string& prefix,
                                       std::uint64_t most);

/// Reports every annotation that the export cannot express or was not asked to write (SML8001,
/// SML8002), and every extension that it omits (SML8004).
void report_losses(const LinkedModel& model, const UrdfExport& options, DiagnosticSink& sink);

/// The folders of the files of a new model.
enum class SmurfLayout : std::uint8_t {
  phobos,   ///< smurf/NAME.smurf, smurf/NAME_*.yml, urdf/NAME.urdf
  flat,     ///< all in one folder
  in_place  ///< the URDF is not moved; the other files as in flat
};

/// The joints that get a motor.
enum class MotorChoice : std::uint8_t { declared, all, none };

/// The reader whose form of sections is written.
enum class SmurfStyle : std::uint8_t {
  mars,    ///< `joint`, contact sensors of collisions
  phobos,  ///< `joints`, contact sensors of links
};

/// The options of import_urdf().
struct UrdfImport {
  std::string name{};  ///< of the files
  std::string output_folder = ".";
  /// Absolute path that relative paths start from; "": the current folder of the process.
  std::string current_folder = {};
  SmurfLayout layout = SmurfLayout::phobos;
  MotorChoice motors = MotorChoice::declared;
  SmurfStyle style = SmurfStyle::mars;
  const xml::Document* srdf = nullptr;  ///< may be null
  /// The copies of meshes and textures that the model should name instead: absolute paths by
  /// MeshReference::path.
  std::map<std::string, std::string> copies{};
};

/// Makes a SMURF model around a URDF. The URDF changes in two ways only: mesh paths are re-based,
/// also those in packages, and an unnamed collision gets a name where a sensor must refer to it.
/// Reports what has no section as SML8101. Precondition: model.robot is set.
NewModel import_urdf(const LinkedModel& model, const SourceMap& sources, const UrdfImport& options,
                     DiagnosticSink& sink);

/// How far two models differ. Zero everywhere means the same robot.
struct Proof {
  std::size_t links = 0;
  std::size_t joint_positions = 0;  ///< number of configurations that were compared
  double position = 0;              ///< largest distance of a link frame, m
  double angle = 0;                 ///< largest rotation between link frames, rad
  double mass = 0;                  ///< relative difference of the total mass
  double center_of_mass = 0;        ///< m, at zero positions
  double inertia = 0;               ///< relative difference of the inertia about the centre of mass
  double limits = 0;                ///< largest difference of a limit
  std::string difference;           ///< first difference in words; empty when there is none

  bool holds() const { return difference.empty(); }
};

/// Changes that are expected in the result of a conversion.
struct ProofScope {
  std::string prefix{};          ///< put before all names of the result
  bool may_merge_links = false;  ///< links on fixed joints may be missing
  bool may_add_base = false;     ///< the result may have a new link `world` and its joint
  bool may_change_limits = false;
  bool may_change_materials = false;  ///< to those of the annotations
};
ProofScope proof_scope(const UrdfExport& options);

/// Compares kinematics at zero and at seeded random joint positions, masses, limits, materials of
/// visuals and collisions of contact sensors, by names.
/// Links and joints that only one of the two has are a difference.
Proof compare_models(const LinkedModel& source, const LinkedModel& result,
                     const ProofScope& scope = {});

/// The verdict of urdfdom on a URDF text.
struct RefereeVerdict {
  bool was_asked = false;  ///< false: the text is not safe for urdfdom
  bool accepts = false;
  std::string messages;  ///< messages of urdfdom, one per line
};

/// Checks the text with urdfdom in this process. Precondition: our own checks found no error in the
/// text, because urdfdom before 5.1 crashes on some inputs. Texts with '%' and very large texts are
/// not checked. In the library smurf::referees.
RefereeVerdict ask_urdfdom(const std::string& urdf);

}  // namespace smurf
