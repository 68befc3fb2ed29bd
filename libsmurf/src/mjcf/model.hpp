// SPDX-License-Identifier: BSD-3-Clause
// A model after MuJoCo has compiled it: its bodies in MuJoCo's order, with their joints, shapes and
// masses.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "imports/mass.hpp"
#include "mjcf/file.hpp"

namespace smurf::mjcf {

/// Where an element is: in which file's model, under which prefix, as which copy.
struct Surroundings {
  const ModelFile* file = nullptr;
  std::string prefix, suffix;
  const DefaultClass* childclass = nullptr;
  xacro::FrameId frame = xacro::kNoFrame;  ///< of the copy or the attached model
  bool weighs_geoms = false;               ///< the mass of the body comes from its shapes
};

struct Joint {
  enum class Type : std::uint8_t { free, ball, slide, hinge };
  Type type = Type::hinge;
  std::string name;
  bool has_name = false;
  Settings settings;
  xacro::FrameId frame = xacro::kNoFrame;
  const ModelFile* file = nullptr;
  Vector3 position{}, axis{0, 0, 1};
  double reference = 0;
  bool is_limited = false;
  std::array<double, 2> range{};
  double damping = 0, friction = 0, armature = 0, stiffness = 0, springref = 0;
  std::optional<std::array<double, 2>> force_range;  ///< of all actuators together
  bool is_aligned = false;  ///< the frame of the free body moves to its centre of mass
};

enum class Shape : std::uint8_t {
  plane,
  hfield,
  sphere,
  capsule,
  ellipsoid,
  cylinder,
  box,
  mesh,
  sdf
};

struct Geom {
  Shape shape = Shape::sphere;
  std::string name;
  Settings settings;
  xacro::FrameId frame = xacro::kNoFrame;
  const ModelFile* file = nullptr;
  Pose pose;
  std::array<double, 3> size{};
  std::string mesh;  ///< name; empty: none
  int group = 0;
  std::int64_t contype = 1, conaffinity = 1;
  std::optional<std::array<double, 4>> rgba;
  std::string material;
  std::optional<MassProperties> mass;  ///< in the frame of the body; none if a mesh is not there
  Pose mesh_pose;                      ///< of the origin of the mesh file in the frame of the body
  mutable bool is_in_urdf = false;     ///< set when the robot is written; annotations come later
};

struct Site {
  std::string name;
  std::uint32_t body = 0;
  Pose pose;
  View element;
  xacro::FrameId frame = xacro::kNoFrame;
};

struct Camera {
  std::string name;
  std::uint32_t body = 0;
  Pose pose;
  Settings settings;
};

struct Body {
  std::string name;
  bool has_name = false;
  View element;
  const ModelFile* file = nullptr;
  xacro::FrameId frame = xacro::kNoFrame;
  std::uint32_t parent = 0;
  Pose pose;
  std::vector<Joint> joints;
  std::vector<Geom> geoms;
  View inertial;
  std::optional<MassProperties> point;  ///< the mass of a point of a soft body
  std::optional<MassProperties> mass;   ///< none: unknown
  bool is_mocap = false;
  double gravcomp = 0;
};

/// A section's element with the surroundings that give its names meaning.
struct Reference {
  std::string_view section;
  View element;
  Surroundings around;
};

/// All of a model, with the models that are attached to it.
struct Model {
  std::deque<ModelFile> files;  ///< the main one first
  std::string name;
  std::deque<Body> bodies;  ///< the world first
  std::deque<Site> sites;
  std::deque<Camera> cameras;
  std::vector<Reference>
      sections;  ///< the elements of actuators, sensors and so on, with those of attached models
  std::vector<xacro::Frame> frames{1};
};

/// Adds what the file says; false if there is nothing to read.
bool build(SourceId root, Reporter& reporter, Model& model);

/// The pose that `pos` and one of the orientations of an element give.
Pose pose_of(const Settings& settings, const Compiler& compiler, Reporter& reporter,
             std::string_view position = "pos");
/// The shortest turn that takes z to a direction.
Quaternion turn_from_z(const Vector3& direction);

/// Reads a joint, and a geom with its mass.
Joint read_joint(View element, const Surroundings& around, Reporter& reporter);
class Meshes;
/// The value of a name in the model of its surroundings.
std::string full_name(std::string_view name, const Surroundings& around);
std::optional<Geom> read_geom(View element, const Surroundings& around, Meshes& meshes,
                              bool is_fixed, Reporter& reporter);
/// The bodies of the points of `<flexcomp>`, at their poses in the body around it; nothing if they
/// are not known here.
std::vector<Body> points_of_flex(View element, const Pose& X, const Surroundings& around,
                                 Reporter& reporter);
/// Reports names that nothing has.
void check_references(const Model& model, Reporter& reporter);
/// Reports values that MuJoCo refuses when it compiles the model.
void check_refusals(const Model& model, Reporter& reporter);
/// Takes bodies without joints into their parents, and turns free bodies to their principal axes,
/// where the compiler is asked to.
void arrange(Model& model);
/// Whether the robot has a link for the world: not if one body that floats is all there is.
bool needs_world(const Model& model);
/// Whether a shape touches any other.
bool touches(const Geom& geom);
/// Whether one mask of SMURF says which others it touches.
bool has_one_mask(const Geom& geom);
/// Whether such masks are needed: not all shapes touch each other.
bool has_masks(const Model& model);
/// Gives names to bodies and joints without one, by their index, and to shapes that touch others.
void name_all(Model& model);
/// Stiffness and damping from `springdamper`, which depend on the inertia that a joint moves.
void tune_springs(Model& model, Reporter& reporter);
/// Reports what MuJoCo does as it is written, and the author hardly meant: SML9308 to 9310, 9320.
void report_slips(const Model& model, Reporter& reporter);
/// Gives all bodies their masses, and reports those that MuJoCo refuses.
void weigh(Model& model, Reporter& reporter);

}  // namespace smurf::mjcf
