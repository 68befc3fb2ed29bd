// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/scene_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/files/path.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/vectors.hpp"
#include "base/text/unique_names.hpp"
#include "base/text/words.hpp"
#include "flatten/scene_shapes.hpp"
#include "link/kinematics.hpp"

namespace smurf {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
LinkInertial diagonal(double mass, double ixx, double iyy, double izz) {
  return {.mass = mass, .X_LC = {}, .ixx = ixx, .iyy = iyy, .izz = izz};
}

class SolidMass {
 public:
  explicit SolidMass(double mass) : mass_(mass) {}

  LinkInertial operator()(const FlatBox& box) const {
    const double x = box.size[0] * box.size[0];
    const double y = box.size[1] * box.size[1];
    const double z = box.size[2] * box.size[2];
    return diagonal(mass_, mass_ * (y + z) / 12, mass_ * (x + z) / 12, mass_ * (x + y) / 12);
  }
  LinkInertial operator()(const FlatSphere& sphere) const { return ball(sphere.radius); }
  LinkInertial operator()(const FlatCylinder& cylinder) const {
    return rod(cylinder.radius, cylinder.length);
  }
  /// Approximation for a format without the inertia of a capsule: a cylinder of the same length.
  LinkInertial operator()(const FlatCapsule& capsule) const {
    return rod(capsule.radius, capsule.length + capsule.radius);
  }
  template <class Other>
  LinkInertial operator()(const Other&) const {
    return ball(0.5);
  }

 private:
  LinkInertial ball(double radius) const {
    const double i = 0.4 * mass_ * radius * radius;
    return diagonal(mass_, i, i, i);
  }
  LinkInertial rod(double radius, double length) const {
    const double across = mass_ * (3 * radius * radius + length * length) / 12;
    return diagonal(mass_, across, across, mass_ * radius * radius / 2);
  }

  double mass_;
};

}  // namespace

std::string safe_name(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (c == '/') {
      name += "__";
    } else {
      name += is_letter(c) || is_digit(c) ? c : '_';
    }
  }
  if (name.empty() || is_digit(name.front())) name.insert(name.begin(), '_');
  return name;
}

std::vector<std::string> safe_names(const FlatScene& scene) {
  std::vector<std::string> names;
  UniqueNames unique;
  unique.take("world");
  for (const FlatInstance& instance : scene.instances) {
    names.push_back(unique.add(safe_name(instance.path)));
  }
  return names;
}

const LinkedModel* robot_of(const LinkedScene& scene, std::size_t instance) {
  const LinkedModel* model = scene.model(scene.instances[instance]);
  return model != nullptr && model->robot && !model->tree.roots.empty() ? model : nullptr;
}

std::string link_name(const LinkedModel& model, std::size_t link) {
  return model.robot->links[link].name.value_or("link_" + std::to_string(link));
}

std::string root_link_name(const LinkedModel& model) {
  return link_name(model, to_size(model.tree.roots.front()));
}

std::optional<std::size_t> carried_link(const LinkedModel& model, std::size_t joint) {
  if (!model.tree.joint_child[joint]) return std::nullopt;
  const std::size_t child = to_size(*model.tree.joint_child[joint]);
  const auto& parent = model.tree.parent_joint[child];
  return parent && to_size(*parent) == joint ? std::optional<std::size_t>(child) : std::nullopt;
}

bool closes_loop(const LinkedModel& model, std::size_t joint) {
  const auto& parent = model.tree.joint_parent[joint];
  const auto& child = model.tree.joint_child[joint];
  return parent && child && *parent != *child && !carried_link(model, joint);
}

std::vector<std::size_t> anchor_groups(const FlatScene& scene) {
  const std::size_t count = scene.instances.size();
  constexpr std::size_t kUnknown = static_cast<std::size_t>(-1);
  std::vector<std::size_t> groups(count, kUnknown);
  std::vector<bool> is_walking(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::size_t> chain;
    std::size_t at = i;
    while (groups[at] == kUnknown && !is_walking[at]) {
      is_walking[at] = true;
      chain.push_back(at);
      const FlatAttachment& anchor = scene.instances[at].anchor;
      if (anchor.kind != Attachment::Kind::link) break;
      at = anchor.index;
    }
    const std::size_t end = groups[at] != kUnknown ? groups[at] : at;
    for (const std::size_t member : chain) groups[member] = end;
  }
  return groups;
}

std::optional<std::size_t> anchor_link(const SceneExport& scene, std::size_t instance) {
  const FlatAttachment& anchor = scene.flat.instances[instance].anchor;
  if (anchor.kind != Attachment::Kind::link) return std::nullopt;
  const LinkedModel* model = robot_of(scene.scene, anchor.index);
  if (model == nullptr) return std::nullopt;
  const std::optional<std::uint32_t> link = model->link_names.find(anchor.link);
  if (!link) return std::nullopt;
  return std::size_t{*link};
}

std::optional<Pose> pose_on_anchor(const SceneExport& scene, std::size_t instance,
                                   LinkFrames& frames) {
  const std::optional<std::size_t> link = anchor_link(scene, instance);
  if (!link) return std::nullopt;
  const FlatInstance& here = scene.flat.instances[instance];
  const FlatInstance& other = scene.flat.instances[here.anchor.index];
  const std::optional<Pose>& X_OL = frames_of(scene, here.anchor.index, frames)[*link];
  if (!X_OL || !other.X_WE || !here.X_WE) return std::nullopt;
  return inverse(*other.X_WE * *X_OL) * *here.X_WE;
}

std::optional<LinkInertial> inertial_of(const urdf::Link& link) {
  if (!link.inertial || !link.inertial->mass || *link.inertial->mass <= 0) return std::nullopt;
  const urdf::Inertial& inertial = *link.inertial;
  return LinkInertial{*inertial.mass,           urdf::to_pose(inertial.origin),
                      inertial.ixx.value_or(0), inertial.ixy.value_or(0),
                      inertial.ixz.value_or(0), inertial.iyy.value_or(0),
                      inertial.iyz.value_or(0), inertial.izz.value_or(0)};
}

LinkInertial smallest_mass() { return SolidMass(0.01)(FlatSphere{0.01}); }

LinkInertial solid_mass(const FlatGeometry& geometry, double mass) {
  return std::visit(SolidMass(mass), geometry);
}

std::optional<Vector3> joint_axis(const urdf::Joint& joint) {
  Vector3 axis = joint.axis.value_or({1, 0, 0});
  double largest = 0;
  for (const double value : axis) largest = std::max(largest, std::abs(value));
  if (!(largest > 0)) return std::nullopt;
  constexpr double kShort = 1e-3;
  constexpr double kLong = 1e3;
  if (largest > kShort && largest < kLong) return axis;
  for (double& value : axis) value /= largest;  // first, because squares may underflow
  const double length = std::sqrt(dot(axis, axis));
  for (double& value : axis) value /= length;
  return axis;
}

double start_position(const LinkedModel& model, const urdf::Joint& joint,
                      const JointPositions& positions) {
  return joint.has_one_axis() ? position_of(model, joint, positions) : 0;
}

bool is_movable(const FlatInstance& instance) {
  if (is_old_scene(instance.type)) return false;
  const Value* movable = find(instance.properties, "movable");
  if (const bool* given = movable != nullptr ? std::get_if<bool>(&movable->data) : nullptr) {
    return *given;
  }
  // primitives.cpp presets: boxes and spheres move.
  return !instance.shapes.empty() &&
         (std::holds_alternative<FlatBox>(instance.shapes.front().geometry) ||
          std::holds_alternative<FlatSphere>(instance.shapes.front().geometry));
}

bool is_fixed_to_world(const FlatInstance& instance) {
  if (instance.model || instance.shapes.empty()) {
    return instance.anchor.kind == Attachment::Kind::world;
  }
  return !is_movable(instance);
}

double mass_of(const FlatInstance& instance) {
  const auto mass = number_of(find(instance.properties, "mass"));
  return mass && *mass > 0 ? *mass : 1;
}

std::vector<const Light*> world_lights(const SceneExport& scene) {
  std::vector<const Light*> lights;
  for (const SceneUse& use : scene.scene.uses) {
    const SceneFile& file = scene.scene.file(use);
    if (use.outer && path::extension(file.path) == ".smurfa") continue;
    for (const Light& light : file.scene.lights) lights.push_back(&light);
  }
  for (const FlatOldScene& old : scene.flat.old_scenes) {
    for (const Light& lamp : old.lamps) lights.push_back(&lamp);
  }
  return lights;
}

Vector3 direction_of(const Light& light) {
  const Vector3 from = light.position.value_or({0, 0, 0});
  const Vector3 to = light.look_at.value_or({from[0], from[1], from[2] - 1});
  Vector3 way{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  const double length = hypotenuse(way[0], way[1], way[2]);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, -1};
  for (double& component : way) component /= length;
  return way;
}

Quaternion rotation_onto(const Vector3& from, const Vector3& to) {
  const auto halfway = [](const Vector3& a, const Vector3& b) {
    return normalized({1 + a[0] * b[0] + a[1] * b[1] + a[2] * b[2], a[1] * b[2] - a[2] * b[1],
                       a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
  };
  if (from[0] * to[0] + from[1] * to[1] + from[2] * to[2] >= 0) return halfway(from, to);
  // Near half a turn, the sum above loses precision, so the rotation is divided into half a turn
  // and the rest.
  const Quaternion half_turn =
      normalized(std::abs(from[1]) < 0.5 ? Quaternion{0, -from[2], 0, from[0]}
                                         : Quaternion{0, 0, from[2], -from[1]});
  return multiply(halfway({-from[0], -from[1], -from[2]}, to), half_turn);
}

Rgba color_or(const Field<Color>& color, const Rgba& fallback) {
  if (!color) return fallback;
  return {color->r.value_or(fallback[0]), color->g.value_or(fallback[1]),
          color->b.value_or(fallback[2]), color->a.value_or(fallback[3])};
}

}  // namespace smurf
