// SPDX-License-Identifier: BSD-3-Clause
// A model or a world as libsdformat reads it: scopes of names, the frames in them, links and
// joints.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sdf/files.hpp"

namespace smurf::sdformat {

struct Scope;

/// What has a frame: a link, a joint, a `<frame>`, a model in another model or in the world.
struct Vertex {
  enum class Kind : std::uint8_t { link, joint, frame, model };
  enum class State : std::uint8_t { open, visiting, done };
  Kind kind = Kind::frame;
  std::string name;
  View element;
  Scope* scope = nullptr;  ///< whose names it uses
  Scope* inner = nullptr;  ///< of a model
  View pose;               ///< the `<pose>` that is used, which may be that of an include
  std::string relative_to;
  std::string attached_to;  ///< of a frame; the child of a joint
  Pose raw;
  State state = State::open;
  Pose X_S;  ///< in the frame of its scope, once the state is done
};

/// The names of a model or a world.
struct Scope {
  std::string name;
  std::string prefix;  ///< of names in the result: "arm::"
  View element;
  const SdfFile* file = nullptr;
  Scope* outer = nullptr;
  Vertex* vertex = nullptr;  ///< that of the model in the outer scope; null for the outermost one
  int depth = 0;             ///< models around it
  bool is_world = false;
  bool is_static = false;
  bool is_merged = false;  ///< its elements belong to the outer scope, too
  std::string placement_frame, canonical_link;
  Span placement_place;
  std::map<std::string, Vertex*, std::less<>> names;
  std::vector<Vertex*> order;
  xacro::FrameId frame = xacro::kNoFrame;  ///< of the include
};

using LinkIndex = std::uint32_t;

/// A link, or the world.
struct Body {
  std::optional<LinkIndex> link;
  friend bool operator==(const Body&, const Body&) = default;
};

struct Link {
  Vertex* vertex = nullptr;
  std::string name;  ///< in the result
  bool is_static = false;
  Pose X_W;
  std::optional<MassProperties> mass;  ///< in the frame of `X_inertial`; none: unknown
  Pose X_inertial;                     ///< in the frame of the link
  Place of_mass, of_center, of_inertia;
  bool has_inertial = false;
};

/// `<axis>` or `<axis2>`.
struct Axis {
  View element;          ///< empty if the file has none
  Vector3 xyz{0, 0, 1};  ///< in the frame of the joint
  double lower = -kUnlimited, upper = kUnlimited;
  double effort = kUnlimited, velocity = kUnlimited;
  double damping = 0, friction = 0;
  bool has_limits() const { return lower > -kUnlimited || upper < kUnlimited; }
};

struct Joint {
  enum class Type : std::uint8_t {
    fixed,
    revolute,
    continuous,
    prismatic,
    ball,
    universal,
    revolute2,
    screw,
    gearbox
  };
  Vertex* vertex = nullptr;
  std::string name;  ///< in the result
  Type type = Type::fixed;
  Body parent, child;
  std::string parent_name, child_name;  ///< as they are written
  Pose X_W;
  bool is_at_child = false;  ///< its frame is that of the child
  std::array<Axis, 2> axes;
  double travel = 0;  ///< of a screw: metres for each radian
  bool is_in_tree = false;
  bool closes_loop = false;  ///< beside the tree, and `<gazebo>` says so
};

/// A light of a world.
struct Light {
  View element;
  View include;  ///< which names its file; empty without one
  Scope* scope = nullptr;
};

/// All of a file.
struct Model {
  std::deque<Scope> scopes;  ///< the outermost one first
  std::deque<Vertex> vertices;
  std::deque<Link> links;
  std::deque<Joint> joints;
  std::vector<Light> lights;
  std::vector<xacro::Frame> frames{1};
  std::string name;
  View element;
  Pose X_W;  ///< of a model that is the whole file
  /// The model belongs to a world, and becomes an entity of a scene. The entity has its pose, and
  /// each of its heightmaps becomes another entity.
  bool is_entity = false;
};

/// Adds what the file says; false if there is nothing to read.
bool build(Files& files, Model& model);
/// Reads a model of a world again, as one that is alone.
void build_part(Files& files, const Scope& part, Model& model);
/// Resolves poses, ends of joints and axes, and reports names that nothing has.
void resolve(Model& model, Reporter& reporter);
/// Chooses the joints that hold each link, and reports those that close a loop.
void arrange(Model& model, Reporter& reporter);
/// Gives links their masses.
void weigh(Model& model, Files& files, Reporter& reporter);

/// The file of an element's scope.
inline const SdfFile& file_of(const Vertex& vertex) {
  const Scope* scope = vertex.inner != nullptr ? vertex.inner : vertex.scope;
  return *scope->file;
}

/// The poses of things in each other, by the graph of `relative_to`.
class Frames {
 public:
  explicit Frames(Reporter& reporter) : reporter_(reporter) {}

  /// In the frame of its scope. A cycle is reported, and the written pose is used.
  const Pose& in_scope(Vertex& vertex);
  Pose in_world(Vertex& vertex);
  /// The frame of a name in a scope: "", `__model__`, `world`, `a`, `n::a`. Reports a name that
  /// nothing has at `place`.
  Pose express(Scope& scope, std::string_view name, Span place);
  /// The same for shapes, sensors, lights and axes, whose frames libsdformat looks for only when a
  /// program asks: a name that nothing has is ignored, which is a warning.
  std::optional<Pose> express_late(Scope& scope, std::string_view name, Span place);
  /// Null if nothing in a scope has the name.
  static Vertex* find(const Scope& scope, std::string_view name);
  /// The link that a name moves with, or the world; none if there is none.
  std::optional<Body> body_of(Scope& scope, std::string_view name, int depth = 0);
  std::optional<Body> canonical(Scope& scope, int depth = 0);
  void index_links(std::deque<Link>& links);

 private:
  Pose in(Vertex& vertex, const Scope& target);
  std::optional<Pose> pose_of(Scope& scope, std::string_view name);

  Reporter& reporter_;
  std::map<const Vertex*, LinkIndex> links_;
  int depth_ = 0;
};

/// The link that is the root of the result; none if all hangs on a link `world`.
std::optional<LinkIndex> root_of(const Model& model);

/// The result of a model.
std::string write_robot(Model& model, Files& files, Reporter& reporter,
                        xacro::Expansion& expansion);

}  // namespace smurf::sdformat
