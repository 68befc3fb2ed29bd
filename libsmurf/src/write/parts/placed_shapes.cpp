// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/placed_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "base/files/path.hpp"
#include "write/parts/annotated_colors.hpp"

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
    const auto known = model_.resources.find(*mesh.filename);
    const std::string& file = known != model_.resources.end() ? known->second : *mesh.filename;
    return FlatMesh{file, mesh.scale.value_or({1, 1, 1})};
  }

 private:
  const FlatModel& model_;
};

/// The material that a visual refers to, of the robot or of another visual, as in urdfdom; null if
/// there is none.
const urdf::Material* definition_of(const urdf::Visual& visual, const LinkedModel& model) {
  if (!visual.material->name) return nullptr;
  const auto index = model.material_names.find(*visual.material->name);
  if (!index) return nullptr;
  const std::vector<urdf::Material>& materials = model.robot->materials;
  if (*index < materials.size()) return &materials[*index];
  const VisualIndex place = model.visual_materials[*index - materials.size()];
  return &*model.robot->links[place.link].visuals[place.visual].material;
}

}  // namespace

std::optional<FlatGeometry> to_flat(const urdf::Geometry& geometry, const FlatModel& model) {
  return std::visit(GeometryReader(model), geometry.shape);
}

std::optional<Rgba> color_of(const urdf::Visual& visual, const LinkedModel& model) {
  if (!visual.material) return std::nullopt;
  if (visual.material->rgba) return *visual.material->rgba;
  const urdf::Material* material = definition_of(visual, model);
  return material == nullptr ? std::nullopt : material->rgba.value();
}

const std::string* written_texture(const urdf::Visual& visual, const LinkedModel& model) {
  if (!visual.material) return nullptr;
  const urdf::Material* material = &*visual.material;
  if (!material->texture && !material->rgba) material = definition_of(visual, model);
  return material != nullptr && material->texture ? &*material->texture : nullptr;
}

std::optional<std::string> texture_of(const urdf::Visual& visual, const LinkedModel& model,
                                      const FlatModel& flat) {
  const std::string* written = written_texture(visual, model);
  if (written == nullptr) return std::nullopt;
  const auto known = flat.resources.find(*written);
  return known != flat.resources.end() ? known->second : *written;
}

bool is_texture_of_mujoco(const MeshReference& reference) {
  return reference.is_texture && reference.exists &&
         path::to_lower(path::extension(reference.filename)) == ".png";
}

Rgba linear_color(const Rgba& color) {
  Rgba linear{};
  for (std::size_t i = 0; i < color.size(); ++i) linear[i] = std::clamp(color[i], 0.0, 1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    double& c = linear[i];
    c = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return linear;
}

const std::vector<std::optional<Pose>>& frames_of(const SceneExport& scene, std::size_t instance,
                                                  LinkFrames& frames) {
  static const std::vector<std::optional<Pose>> none;
  const FlatInstance& flat = scene.flat.instances[instance];
  if (!flat.model) return none;
  return frames.of(scene.scene, scene.flat.models[*flat.model].source, flat.joint_pose,
                   scene.flat.joint_poses);
}

std::vector<ShownLink> shown_links(const SceneExport& scene, std::size_t index, LinkFrames& frames,
                                   AnnotatedColors& colors) {
  const FlatInstance& instance = scene.flat.instances[index];
  const LinkedModel* model = scene.scene.model(scene.scene.instances[index]);
  if (model == nullptr || !model->robot) {
    ShownLink link;
    const Span place = place_of(*instance.entity);
    for (const FlatShape& shape : instance.shapes) {
      link.shapes.push_back({shape.X_ES, shape.geometry, shape.color, place});
    }
    return {std::move(link)};
  }
  const FlatModel& flat = scene.flat.models[*instance.model];
  const std::vector<std::optional<Pose>>& X_EL = frames_of(scene, index, frames);
  std::vector<ShownLink> links;
  for (std::size_t i = 0; i < X_EL.size(); ++i) {
    if (!X_EL[i]) continue;
    const urdf::Link& written = model->robot->links[i];
    ShownLink link{written.name.value_or({}), *X_EL[i], {}};
    const auto add = [&](const auto& part, const std::optional<Rgba>& color) {
      if (auto geometry = to_flat(part.geometry, flat)) {
        link.shapes.push_back({urdf::to_pose(part.origin), std::move(*geometry), color, part.span});
      }
    };
    for (const urdf::Visual& visual : written.visuals) {
      add(visual, colors.of(visual, *model, flat));
    }
    if (written.visuals.empty()) {
      for (const urdf::Collision& collision : written.collisions) add(collision, std::nullopt);
    }
    links.push_back(std::move(link));
  }
  return links;
}

std::vector<PlacedShape> placed_shapes(const SceneExport& scene, std::size_t index,
                                       LinkFrames& frames, AnnotatedColors& colors) {
  const std::optional<Pose>& X_WE = scene.flat.instances[index].X_WE;
  if (!X_WE) return {};
  std::vector<PlacedShape> shapes;
  for (const ShownLink& link : shown_links(scene, index, frames, colors)) {
    const Pose X_WL = *X_WE * link.X_EL;
    for (const LinkShape& shape : link.shapes) {
      shapes.push_back({X_WL * shape.X_LS, shape.geometry, shape.color});
    }
  }
  return shapes;
}

}  // namespace smurf
