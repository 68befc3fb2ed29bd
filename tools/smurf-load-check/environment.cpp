// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/environment.hpp"

#include <algorithm>
#include <string_view>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "flatten/scene_shapes.hpp"
#include "smurf-load-check/heightfield.hpp"

namespace smurf::load_check {
namespace {

bool is_true(const Value* value) {
  const auto* found = value != nullptr ? std::get_if<bool>(&value->data) : nullptr;
  return found != nullptr && *found;
}

/// The image in the order of the engine; image rows go from +y to -y, as in Gazebo and
/// MuJoCo.
HeightfieldShape to_heightfield(const FlatHeightmap& map, const HeightImage& image) {
  HeightfieldShape shape{map.length, map.width, image.columns, image.rows, {}};
  shape.heights.reserve(image.heights.size());
  for (std::size_t row = image.rows; row-- > 0;) {
    for (std::size_t column = 0; column < image.columns; ++column) {
      const float height = image.heights[row * image.columns + column];
      shape.heights.push_back(height * static_cast<float>(map.height));
    }
  }
  return shape;
}

class EnvironmentBuilder {
 public:
  EnvironmentBuilder(const LinkedScene& scene, Plan& plan, const ShapeFiles& files,
                     DiagnosticSink& sink)
      : scene_(scene), plan_(plan), files_(files), sink_(sink) {}

  /// False if it is omitted.
  bool add(const Instance& instance, const FlatInstance& flat) {
    if (flat.shapes.empty() || !flat.X_WE || is_true(find(flat.properties, "movable"))) {
      return false;
    }
    bool is_whole = true;
    for (const FlatShape& flat_shape : flat.shapes) {
      std::optional<Shape> shape = shape_of(flat_shape.geometry, instance);
      is_whole = is_whole && shape.has_value();
      if (!shape) continue;
      ShapePlan& added = plan_.shapes.emplace_back();
      added.name = "entity `" + flat.path + "`";
      added.place = smurf::place_of(scene_.entity(instance));
      added.body = kEnvironment;
      added.X_WS = *flat.X_WE * flat_shape.X_ES;
      added.shape = std::move(*shape);
    }
    return is_whole;
  }

 private:
  std::optional<Shape> shape_of(const FlatGeometry& geometry, const Instance& instance) {
    if (std::holds_alternative<FlatPlane>(geometry)) return PlaneShape{};
    if (const auto* box = std::get_if<FlatBox>(&geometry)) return BoxShape{to_eigen(box->size)};
    if (const auto* sphere = std::get_if<FlatSphere>(&geometry)) return SphereShape{sphere->radius};
    if (const auto* cylinder = std::get_if<FlatCylinder>(&geometry)) {
      return CylinderShape{cylinder->radius, cylinder->length};
    }
    if (const auto* capsule = std::get_if<FlatCapsule>(&geometry)) {
      return CapsuleShape{capsule->radius, capsule->length};
    }
    const auto* map = std::get_if<FlatHeightmap>(&geometry);
    // The heightmaps and meshes that an old scene names are left out.
    if (map == nullptr || path::file_name(map->file) != path::file_name(instance.file)) {
      return std::nullopt;
    }
    return heights(*map, instance);
  }

  std::optional<Shape> heights(const FlatHeightmap& map, const Instance& instance) {
    const auto image = read_height_image(instance.file, files_, pixels_left_);
    if (const auto* found = std::get_if<HeightImage>(&image)) {
      pixels_left_ -= found->heights.size();
      return to_heightfield(map, *found);
    }
    const Entity& entity = scene_.entity(instance);
    sink_
        .report(rules::sml6107_shape_not_buildable,
                entity.file ? entity.file.span : smurf::place_of(entity),
                "the heights of entity `" + instance.path + "` cannot be read")
        .caret = std::get<std::string>(image);
    return std::nullopt;
  }

  const LinkedScene& scene_;
  Plan& plan_;
  const ShapeFiles& files_;
  DiagnosticSink& sink_;
  std::uint64_t pixels_left_ = files_.limits.image_pixels;  ///< for all images of the scene
};

}  // namespace

std::size_t add_environment(const LinkedScene& scene, const FlatScene& flat, Plan& plan,
                            const ShapeFiles& files, DiagnosticSink& sink) {
  EnvironmentBuilder builder(scene, plan, files, sink);
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < flat.instances.size(); ++i) {
    if (flat.instances[i].model) continue;
    if (!builder.add(scene.instances[i], flat.instances[i])) ++left_out;
  }
  return left_out;
}

}  // namespace smurf::load_check
