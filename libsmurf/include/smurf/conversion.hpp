// SPDX-License-Identifier: BSD-3-Clause
// Conversions of whole files. What is refused, proven and reported as lost is decided here, for all
// programs.
//
//     smurf::Session session;
//     smurf::LoadedModel loaded = session.load_model("arm.smurf");
//     const smurf::UrdfResult result = smurf::convert_to_urdf(session, loaded, {});
//     std::cout << (result.refusal ? result.refusal.reason : result.text);
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/asset_copies.hpp"
#include "smurf/check.hpp"
#include "smurf/convert.hpp"
#include "smurf/dialect.hpp"
#include "smurf/flatten.hpp"
#include "smurf/new_model.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

/// Why the result of a conversion must not be written.
struct Refusal {
  enum class Cause : std::uint8_t { findings, options, result };
  std::string reason;  ///< "cannot be converted: urdfdom refuses the file"; "": no refusal
  Cause cause = Cause::result;
  bool can_be_forced = false;  ///< `force` of the request converts it despite that

  explicit operator bool() const { return !reason.empty(); }
};

/// Why a finding makes the result wrong ("urdfdom refuses the file"); none if it does not.
using LossOf = std::function<std::optional<std::string>(const Diagnostic&)>;

/// "cannot be converted: " and the reasons of all findings that make the result wrong; "" if there
/// are none.
std::string why_not_converted(std::span<const Diagnostic> findings, const LossOf& loss_of);

/// Other parsers that must accept the result of a conversion. A null pointer leaves one out.
struct Referees {
  RefereeVerdict (*urdfdom)(const std::string& urdf) = nullptr;
  /// False, with a finding, if tinyxml2 refuses the text or reads other elements.
  bool (*tinyxml2)(xml::Document& document, const SourceMap& sources,
                   DiagnosticSink& sink) = nullptr;
};
/// Both. In the library smurf::referees.
Referees all_referees();

/// What becomes of a collision mesh. Other shapes of collisions are kept.
enum class CollisionShapes : std::uint8_t {
  keep,
  hull,      ///< its convex hull, as a mesh
  boxes,     ///< a box around it
  capsules,  ///< a capsule or a ball around it
  parts,     ///< several convex meshes that fill about the same space
  lighter    ///< about the same surface with fewer triangles
};
/// The shapes for some links.
struct CollisionChoice {
  std::string links;  ///< a pattern of names with `*`; "": all links
  CollisionShapes shapes = CollisionShapes::keep;
};

/// A mesh that is to be divided.
struct DividedMesh {
  std::vector<Vector3> points;         ///< m
  std::vector<std::uint32_t> indices;  ///< three per triangle, which turns left, seen from outside
  std::size_t most_parts = 0;
  double concavity = 0;    ///< the deepest dent of a part, as a part of the size of the mesh
  bool is_closed = false;  ///< it encloses a volume, and need not be repaired before
};
/// Points whose convex hulls are the parts of a mesh.
struct ConvexParts {
  std::vector<std::vector<Vector3>> parts;
  std::string problem;          ///< the reason if there are none: "CoACD failed (signal 11)"
  bool is_for_no_mesh = false;  ///< the reason is not the mesh: there is no CoACD here
};

/// A mesh that is to have fewer triangles.
struct HeavyMesh {
  std::vector<Vector3> points;         ///< m; no two are equal
  std::vector<std::uint32_t> indices;  ///< three per triangle
  /// The surface may move by `near` wherever that saves triangles. If more than this many are left,
  /// it may move by `far`. Both are parts of the longest edge of the box around the mesh.
  std::size_t triangles = 0;
  double near = 0;
  double far = 0;
};
/// The same surface, or about that, with fewer triangles.
struct LighterMesh {
  std::vector<Vector3> points;
  std::vector<std::uint32_t> indices;
  std::string problem;          ///< the reason if there is none
  bool is_for_no_mesh = false;  ///< the reason is not the mesh: there is no meshoptimizer here
};

/// Other shapes for the collision meshes of robots.
struct CollisionRequest {
  std::vector<CollisionChoice> choices = {};  ///< the last one that fits a link counts
  /// Divides a mesh into convex parts; null: this program cannot.
  std::function<ConvexParts(const DividedMesh& mesh)> divide = {};
  /// Takes triangles away from a mesh; null: this program cannot.
  std::function<LighterMesh(const HeavyMesh& mesh)> lighten = {};
  /// Called before work that may take minutes, with a sentence about it; may be null.
  std::function<void(const std::string& sentence)> tell = {};
  /// The folder for new meshes, relative to the output folder; "": they cannot be written.
  std::string folder = {};

  bool changes_something() const;
};

/// A collision mesh that has other shapes in a result.
struct ReplacedCollision {
  std::string mesh;  ///< the file name, as written
  CollisionShapes shapes = CollisionShapes::keep;
  std::size_t parts = 1;
  std::size_t vertices_before = 0;
  std::size_t vertices_after = 0;  ///< 0 for boxes and capsules
  double volume = 0;               ///< of the new shapes, m^3; where they overlap, it counts once
  /// The volume gained, or lost if negative, as a part of that of the mesh; none for an open mesh,
  /// whose volume is not known.
  std::optional<double> gain;
  std::size_t collisions = 0;  ///< that had this mesh, in this size
  std::string kept;  ///< the reason if the mesh is kept: "all its points lie in one plane"
  Span place;        ///< of the first, in the text of the robot
};
/// "12 convex parts; 1204 vertices become 210, volume +3.1 %".
std::string describe(const ReplacedCollision& replaced);

/// What convert_to_urdf() is asked for.
struct UrdfRequest {
  /// With MeshUri::package and without a package_folder, the package is looked up in `packages`. If
  /// it is not there, its folder is the nearest one above the URDF with a package.xml; if there is
  /// none, it is the parent of the folder of the URDF.
  UrdfExport options = {};
  std::map<std::string, std::string> packages = {};  ///< names to folders
  bool force = false;
  Referees referees = {};
  /// The program that the result is for: the result is refused when it does not load there, and
  /// meshes that it does not read are copied to a format that it reads.
  const Reader* reader = nullptr;
  /// The folder for these copies, relative to the output folder; "": they cannot be written.
  std::string mesh_folder = {};
  std::string file_name = "robot.urdf";  ///< of the result, in the output folder
  CollisionRequest collisions = {};
};

/// The comparison of an exported URDF with its source.
struct UrdfProof {
  Proof comparison;
  bool tinyxml2_accepts = false;
  RefereeVerdict urdfdom;
  std::size_t links = 0, joints = 0;  ///< of the result
};

/// What convert_to_urdf() makes; with a refusal, it must not be written.
struct UrdfResult {
  Report report;  ///< of the model
  std::string text;
  std::vector<Diagnostic> losses;    ///< what the URDF does not express
  std::vector<TextFile> meshes;      ///< copies of meshes, by their paths in the output folder
  std::vector<TextFile> new_meshes;  ///< those of collisions, in the same way
  std::vector<ReplacedCollision> collisions;
  /// What the reader of the request loses of the result: "loads the link without this shape
  /// (SML1628 at /robot/link[@name='arm']/...)".
  std::vector<std::string> lost_by_reader;
  std::optional<UrdfProof> proof;  ///< none: refused before the export
  Refusal refusal;
};

/// Checks a model, exports its URDF, reads it again and compares it with the model: urdfdom must
/// accept it, and all link poses, masses, inertias and limits must be equal, except limits that an
/// option changes.
UrdfResult convert_to_urdf(Session& session, LoadedModel& loaded, const UrdfRequest& request);

/// What convert_to_smurf() is asked for.
struct SmurfRequest {
  /// Without a name, the files are called as the URDF, or as the robot if the file has a general
  /// name. The copies are chosen.
  UrdfImport options = {};
  bool has_file = true;                              ///< false: a text without a name
  std::map<std::string, std::string> packages = {};  ///< names to folders
  bool copies_meshes = false;
  bool force = false;
};

/// What convert_to_smurf() makes; with a refusal, it must not be written.
struct SmurfResult {
  Report report;  ///< of the URDF, with what has no section
  NewModel made;
  std::vector<TextFile> texts;  ///< in the output folder
  AssetCopies copies;
  std::size_t dead_motors = 0;   ///< joints without a limit of speed or effort, such as wheels
  std::size_t wrong_mimics = 0;  ///< motors that follow one of another kind of command
  std::size_t for_mars = 0;      ///< errors of the URDF that occur only in models
  Refusal refusal;
};

/// Checks a URDF, makes a SMURF model around it, reads that again and checks it: it must be the
/// same robot, without new errors.
SmurfResult convert_to_smurf(Session& session, LoadedModel& loaded, const SmurfRequest& request);

/// Whether a finding is about something that the result lacks. Added values are not losses.
bool is_loss(const Diagnostic& finding);

/// The form that a format writes unless a user asks for another one.
SceneForm usual_form(const SceneFormat& format);
bool has_form(const SceneFormat& format, SceneForm form);

/// SceneRequest::controllers: motors do not follow controllers.
inline constexpr std::string_view kNoControllers = "none";

/// What convert_scene() is asked for.
struct SceneRequest {
  const SceneFormat& format;
  SceneForm form = usual_form(format);
  const Dialect& dialect = *dialects().front();
  std::optional<BaseChoice> base = {};
  bool ground = false;
  MotorOptions motors = {};
  SelfCollision self_collision = SelfCollision::as_usual;
  /// Leaves out the contacts of links that overlap at the start. Automatic motors do, too.
  bool excludes_overlaps = false;
  std::string srdf = {};  ///< "": those beside the URDFs
  /// A file of controllers of ros2_control; "": those that belong to the models; kNoControllers.
  std::string controllers = {};
  bool links = false;
  std::string assets = {};  ///< folder for the files that the result names; "": they stay
  std::string output_folder = ".";
  std::string current_folder = {};  ///< absolute; "": that of the process
  /// The folder for copies of models that the reader of the format would refuse, relative to the
  /// output folder; "": they cannot be written.
  std::string model_folder = {};
  std::map<std::string, std::string> packages = {};  ///< names to folders
  bool force = false;
  CollisionRequest collisions = {};
};

/// Of the reasons of a reader: "refuses the mesh (...)", or that and how many more there are.
std::string first_of(const std::vector<std::string>& reasons);

/// What convert_scene() makes; with a refusal, it must not be written.
struct SceneResult {
  Report report;     ///< of the scene, with the losses
  std::string text;  ///< empty: refused
  AssetCopies copies;
  std::vector<TextFile> models;      ///< copies of models, by their paths in the output folder
  std::vector<TextFile> new_meshes;  ///< those of collisions, in the same way
  std::vector<ReplacedCollision> collisions;
  std::vector<Diagnostic> losses;  ///< what the format does not express
  /// What the reader of the format ignores in the models to which the result refers.
  std::vector<std::string> lost_by_reader;
  bool has_falling_robots = false;
  Refusal refusal;
};

/// Checks a scene and writes it in a format. The scene is left as it was.
SceneResult convert_scene(Session& session, LoadedScene& loaded, const SceneRequest& request);

/// The same without a format.
struct FlatResult {
  Report report;
  FlatScene flat;
  Refusal refusal;
};
FlatResult convert_to_flat(Session& session, LoadedScene& loaded, const Dialect& dialect,
                           const FlattenOptions& options, bool force);

/// Whether the poses of a scene are known.
struct SceneCheck {
  Report report;
  Refusal refusal;
};
SceneCheck check_scene(Session& session, LoadedScene& loaded, bool force);

}  // namespace smurf
