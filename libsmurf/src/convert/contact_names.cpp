// SPDX-License-Identifier: BSD-3-Clause
// Keeps contact sensors of Gazebo on their collisions when names or links change.
#include <cmath>
#include <map>

#include "base/numbers/exact_math.hpp"
#include "base/text/edits.hpp"
#include "convert/passes.hpp"
#include "link/gazebo_names.hpp"

namespace smurf::passes {
namespace {

/// A shape as text, without its pose.
std::string text_of(const urdf::Geometry& geometry) {
  struct Text {
    std::string operator()(const std::monostate&) const { return {}; }
    std::string operator()(const urdf::Box& box) const {
      return "box " + numbers_text(box.size.value_or({}));
    }
    std::string operator()(const urdf::Sphere& sphere) const {
      return "sphere " + std::to_string(sphere.radius.value_or(0));
    }
    std::string operator()(const urdf::Cylinder& round) const {
      return "round " + std::to_string(round.radius.value_or(0));
    }
    // An older version of URDF has a cylinder in its place.
    std::string operator()(const urdf::Capsule& round) const {
      return "round " + std::to_string(round.radius.value_or(0));
    }
    // Paths may have changed.
    std::string operator()(const urdf::Mesh& mesh) const {
      return "mesh " + numbers_text(mesh.scale.value_or({1, 1, 1}));
    }
  };
  return std::visit(Text(), geometry.shape);
}

bool is_near(const Pose& a, const Pose& b) {
  constexpr double kNear = 1e-9;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(a.position[i] - b.position[i]) <= kNear)) return false;
  }
  return angle_between(a.orientation, b.orientation) <= kNear;
}

/// Collisions of a model in the world, at zero positions.
class PlacedCollisions {
 public:
  explicit PlacedCollisions(const LinkedModel& model)
      : model_(model), frames_(forward_kinematics(model, {})) {}

  std::optional<Pose> pose(const CollisionPlace& at) const {
    if (!frames_[at.link]) return std::nullopt;
    return *frames_[at.link] * urdf::to_pose(collision(at).origin);
  }
  const urdf::Collision& collision(const CollisionPlace& at) const {
    return model_.robot->links[at.link].collisions[at.collision];
  }

  /// Whether a collision has this shape and pose.
  bool is_at(const CollisionPlace& at, const std::string& shape, const Pose& X_WC) const {
    if (text_of(collision(at).geometry) != shape) return false;
    const auto X = pose(at);
    return X && is_near(*X, X_WC);
  }

  /// The collision of the same shape at the same place.
  std::optional<CollisionPlace> find(const std::string& shape, const Pose& X_WC) const {
    for (std::size_t link = 0; link < model_.robot->links.size(); ++link) {
      const auto& collisions = model_.robot->links[link].collisions;
      for (std::size_t i = 0; i < collisions.size(); ++i) {
        if (is_at({link, i}, shape, X_WC)) return CollisionPlace{link, i};
      }
    }
    return std::nullopt;
  }

 private:
  const LinkedModel& model_;
  std::vector<std::optional<Pose>> frames_;
};

}  // namespace

void rename_contacts(const LinkedModel& source, const LinkedModel& result, XmlEdits& edits) {
  const std::vector<ContactName> before = contact_names(source);
  const std::vector<ContactName> after = contact_names(result);
  // Sensors may have been removed, or added at the end.
  if (before.empty() || after.size() < before.size()) return;
  const GazeboNames old_names = gazebo_names(source);
  const GazeboNames new_names = gazebo_names(result);
  const PlacedCollisions placed(source);
  const PlacedCollisions in_result(result);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto meant = find_collision(old_names, before[i].link, before[i].text);
    const auto X_WC = meant ? placed.pose(*meant) : std::nullopt;
    if (!X_WC) continue;
    const std::string shape = text_of(placed.collision(*meant).geometry);
    // Several parts of one mesh are alike.
    const auto named = find_collision(new_names, after[i].link, after[i].text);
    if (named && in_result.is_at(*named, shape, *X_WC)) continue;
    const auto now = in_result.find(shape, *X_WC);
    if (!now) continue;
    const std::string& name = new_names.collisions[now->link][now->collision];
    if (name != after[i].text) edits.replace(after[i].element.text_span(), escape_xml(name));
  }
}

std::size_t known_contacts(const LinkedModel& model) {
  const GazeboNames names = gazebo_names(model);
  std::size_t known = 0;
  for (const ContactName& contact : contact_names(model)) {
    if (find_collision(names, contact.link, contact.text)) ++known;
  }
  return known;
}

}  // namespace smurf::passes
