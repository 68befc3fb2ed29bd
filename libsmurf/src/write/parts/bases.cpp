// SPDX-License-Identifier: BSD-3-Clause
// Which models are fixed to the world, and how deep models are below a floor at z = 0.
#include <algorithm>
#include <cmath>
#include <map>

#include "link/kinematics.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf {
namespace {

/// The third row of the rotation matrix: multiplied by a point, its height in the world.
Vector3 height_row(const Quaternion& q) {
  return {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x),
          1 - 2 * (q.x * q.x + q.y * q.y)};
}

/// The lowest point of a shape in the world; none for a plane, and for a mesh that is not read.
class Lowest {
 public:
  Lowest(const Vector3& row, const std::vector<std::array<float, 3>>* points)
      : row_(row), points_(points) {}

  using Height = std::optional<double>;
  Height operator()(const FlatBox& box) const {
    return -(std::abs(row_[0]) * box.size[0] + std::abs(row_[1]) * box.size[1] +
             std::abs(row_[2]) * box.size[2]) /
           2;
  }
  Height operator()(const FlatSphere& sphere) const { return -sphere.radius; }
  Height operator()(const FlatCylinder& cylinder) const {
    const double tilt = std::sqrt(std::max(0.0, 1 - row_[2] * row_[2]));
    return -std::abs(row_[2]) * cylinder.length / 2 - tilt * cylinder.radius;
  }
  Height operator()(const FlatCapsule& capsule) const {
    return -std::abs(row_[2]) * capsule.length / 2 - capsule.radius;
  }
  Height operator()(const FlatMesh& mesh) const {
    Height lowest;
    if (points_ == nullptr) return lowest;
    for (const std::array<float, 3>& point : *points_) {
      double height = 0;
      for (std::size_t i = 0; i < 3; ++i) height += row_[i] * mesh.scale[i] * point[i];
      lowest = std::min(lowest.value_or(height), height);
    }
    return lowest;
  }
  template <class Other>
  Height operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  const Vector3& row_;
  const std::vector<std::array<float, 3>>* points_;
};

class FloorCheck {
 public:
  explicit FloorCheck(const SceneExport& scene) : scene_(scene) {}

  /// Below 0 if a part is below the floor.
  double lowest(std::size_t i) {
    const FlatInstance& instance = scene_.flat.instances[i];
    const LinkedModel* model = robot_of(scene_.scene, i);
    if (model == nullptr || !instance.X_WE) return 0;
    const std::vector<bool> is_fixed = fixed_links(*model, i);
    double lowest = 0;
    const auto& frames = frames_of(scene_, i, frames_);
    const FlatModel& flat = scene_.flat.models[*instance.model];
    const bool has_collisions =
        std::any_of(model->robot->links.begin(), model->robot->links.end(),
                    [](const urdf::Link& link) { return !link.collisions.empty(); });
    const auto add = [&](const auto& shapes, const Pose& X_WL) {
      for (const auto& shape : shapes) {
        const auto geometry = to_flat(shape.geometry, flat);
        if (geometry)
          lowest = std::min(lowest, height(*geometry, X_WL * urdf::to_pose(shape.origin)));
      }
    };
    for (std::size_t link = 0; link < frames.size(); ++link) {
      if (!frames[link] || is_fixed[link]) continue;
      const Pose X_WL = *instance.X_WE * *frames[link];
      if (has_collisions) {
        add(model->robot->links[link].collisions, X_WL);
      } else {
        add(model->robot->links[link].visuals, X_WL);
      }
    }
    return lowest;
  }

 private:
  /// Links that do not move relative to the world.
  std::vector<bool> fixed_links(const LinkedModel& model, std::size_t i) const {
    std::vector<bool> is_fixed(model.robot->links.size(), false);
    if (scene_.flat.instances[i].anchor.kind != Attachment::Kind::world) return is_fixed;
    std::vector<std::size_t> open{to_size(model.tree.roots.front())};
    while (!open.empty()) {
      const std::size_t link = open.back();
      open.pop_back();
      is_fixed[link] = true;
      for (const JointIndex joint : model.tree.child_joints[link]) {
        const auto child = carried_link(model, to_size(joint));
        if (child && model.joint(joint).type == urdf::JointType::fixed) open.push_back(*child);
      }
    }
    return is_fixed;
  }

  double height(const FlatGeometry& geometry, const Pose& X_WS) {
    const auto* mesh = std::get_if<FlatMesh>(&geometry);
    const auto* points = mesh != nullptr ? points_of(mesh->file) : nullptr;
    const Vector3 row = height_row(X_WS.orientation);
    const std::optional<double> below = std::visit(Lowest(row, points), geometry);
    return below ? X_WS.position[2] + *below : 0;
  }

  const std::vector<std::array<float, 3>>* points_of(const std::string& file) {
    if (!scene_.meshes.triangles) return nullptr;
    const auto [known, is_new] = points_.try_emplace(file);
    if (is_new) known->second = scene_.meshes.triangles(file, TexturePoints::ignored).points;
    return &known->second;
  }

  const SceneExport& scene_;
  LinkFrames frames_;
  std::map<std::string, std::vector<std::array<float, 3>>> points_;
};

}  // namespace

void anchor_bases(FlatScene& flat, const LinkedScene& scene, BaseChoice choice) {
  if (choice == BaseChoice::floating) return;
  for (std::size_t i = 0; i < flat.instances.size(); ++i) {
    FlatInstance& instance = flat.instances[i];
    const LinkedModel* model = robot_of(scene, i);
    if (model == nullptr || instance.anchor.kind != Attachment::Kind::none) continue;
    if (instance.entity->anchor.written) continue;
    if (choice == BaseChoice::world_roots_fixed && root_link_name(*model) != "world") continue;
    instance.anchor.kind = Attachment::Kind::world;
  }
}

std::vector<BelowFloor> below_floor(const SceneExport& scene) {
  constexpr double kLeast = 1e-3;  // m
  std::vector<BelowFloor> found;
  FloorCheck check(scene);
  for (std::size_t i = 0; i < scene.flat.instances.size(); ++i) {
    const double depth = -check.lowest(i);
    if (depth > kLeast) found.push_back({i, depth});
  }
  return found;
}

}  // namespace smurf
