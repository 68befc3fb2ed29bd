// SPDX-License-Identifier: BSD-3-Clause
#include "write/placed_shapes.hpp"

namespace smurf {
namespace {

class GeometryReader {
 public:
  explicit GeometryReader(const FlatModel& model) : model_(model) {}

  std::optional<FlatGeometry> operator()(std::monostate) const { return std::nullopt; }
  std::optional<FlatGeometry> operator()(const urdf::Box& box) const {
    if (!box.size) return std::nullopt;
    return FlatBox{*box.size};
  }
  std::optional<FlatGeometry> operator()(const urdf::Sphere& sphere) const {
    if (!sphere.radius) return std::nullopt;
    return FlatSphere{*sphere.radius};
  }
  std::optional<FlatGeometry> operator()(const urdf::Cylinder& cylinder) const {
    if (!cylinder.radius || !cylinder.length) return std::nullopt;
    return FlatCylinder{*cylinder.radius, *cylinder.length};
  }
  std::optional<FlatGeometry> operator()(const urdf::Capsule& capsule) const {
    if (!capsule.radius || !capsule.length) return std::nullopt;
    return FlatCapsule{*capsule.radius, *capsule.length};
  }
  std::optional<FlatGeometry> operator()(const urdf::Mesh& mesh) const {
    if (!mesh.filename) return std::nullopt;
    for (const auto& [written, file] : model_.resources) {
      if (written == *mesh.filename) return FlatMesh{file, mesh.scale.value_or({1, 1, 1})};
    }
    return FlatMesh{*mesh.filename, mesh.scale.value_or({1, 1, 1})};
  }

 private:
  const FlatModel& model_;
};

}  // namespace

std::optional<FlatGeometry> to_flat(const urdf::Geometry& geometry, const FlatModel& model) {
  return std::visit(GeometryReader(model), geometry.shape);
}

std::optional<Rgba> color_of(const urdf::Visual& visual, const urdf::Robot& robot) {
  if (!visual.material) return std::nullopt;
  if (visual.material->rgba) return *visual.material->rgba;
  for (const urdf::Material& material : robot.materials) {
    if (material.name && visual.material->name && *material.name == *visual.material->name) {
      return material.rgba.value;
    }
  }
  return std::nullopt;
}

std::vector<PlacedShape> placed_shapes(const SceneExport& scene, std::size_t index,
                                       LinkFrames& frames) {
  const FlatInstance& instance = scene.flat.instances[index];
  if (!instance.X_WE) return {};
  std::vector<PlacedShape> shapes;
  for (const FlatShape& shape : instance.shapes) {
    shapes.push_back({*instance.X_WE * shape.X_ES, shape.geometry, shape.color});
  }
  const Instance& source = scene.scene.instances[index];
  const LinkedModel* model = scene.scene.model(source);
  if (model == nullptr || !model->robot) return shapes;
  const FlatModel& flat = scene.flat.models[*instance.model];
  const std::vector<std::optional<Pose>>& X_EL = frames.of(scene.scene, source);
  for (std::size_t i = 0; i < X_EL.size(); ++i) {
    if (!X_EL[i]) continue;
    const urdf::Link& link = model->robot->links[i];
    const Pose X_WL = *instance.X_WE * *X_EL[i];
    const auto add = [&](const auto& part, const std::optional<Rgba>& color) {
      if (auto geometry = to_flat(part.geometry, flat)) {
        shapes.push_back({X_WL * urdf::to_pose(part.origin), std::move(*geometry), color});
      }
    };
    for (const urdf::Visual& visual : link.visuals) add(visual, color_of(visual, *model->robot));
    if (!link.visuals.empty()) continue;
    for (const urdf::Collision& collision : link.collisions) add(collision, std::nullopt);
  }
  return shapes;
}

}  // namespace smurf
