// SPDX-License-Identifier: BSD-3-Clause
// Sizes and defaults of MARS (entity_generation primitives.cpp:115-150, NodeData.cpp,
// NodePhysics.cpp); heightmaps as Phobos 0.7 writes them and as MARS reads a terrain node.
#include "flatten/scene_shapes.hpp"

#include <cmath>

#include "base/files/path.hpp"

namespace smurf {
namespace {

/// A length from the first of the keys that contains one.
double length_of(const Value::Object& object, std::initializer_list<std::string_view> keys,
                 double fallback) {
  for (const std::string_view key : keys) {
    const auto length = number_of(find(object, key));
    if (length && *length > 0 && std::isfinite(*length)) return *length;
  }
  return fallback;
}

Vector3 extent_of(const Value::Object& properties, const Vector3& preset) {
  const Value::Object* extent = object_of(find(properties, "extend"));
  if (extent == nullptr) return preset;
  return {length_of(*extent, {"x"}, preset[0]), length_of(*extent, {"y"}, preset[1]),
          length_of(*extent, {"z"}, preset[2])};
}

std::optional<Rgba> color_of(const Value::Object& properties) {
  const Value::Object* material = object_of(find(properties, "material"));
  const Value::Object* color =
      material != nullptr ? object_of(find(*material, "diffuseColor")) : nullptr;
  if (color == nullptr) return std::nullopt;
  const auto component = [&](std::string_view key, double fallback) {
    return std::fmin(1, std::fmax(0, number_of(find(*color, key)).value_or(fallback)));
  };
  return Rgba{component("r", 0), component("g", 0), component("b", 0), component("a", 1)};
}

/// `extend` of a round primitive contains its radius, then its length.
std::optional<FlatGeometry> primitive(std::string_view type, const Value::Object& properties) {
  if (type == "plane") {
    const Vector3 extent = extent_of(properties, {10, 10, 0});
    return FlatPlane{extent[0], extent[1]};
  }
  if (type == "box") return FlatBox{extent_of(properties, {1, 1, 1})};
  const Vector3 extent = extent_of(properties, {0.5, 1, 0});
  if (type == "sphere") return FlatSphere{extent[0]};
  if (type == "cylinder") return FlatCylinder{extent[0], extent[1]};
  if (type == "capsule") return FlatCapsule{extent[0], extent[1]};
  return std::nullopt;
}

}  // namespace

FlatHeightmap heightmap_of(const Value::Object& properties, std::string file) {
  return {std::move(file), length_of(properties, {"length", "t_height"}, 1),
          length_of(properties, {"width", "t_width"}, 1),
          length_of(properties, {"height", "t_scale"}, 1)};
}

const Value::Object* object_of(const Value* value) {
  return value != nullptr ? std::get_if<Value::Object>(&value->data) : nullptr;
}

std::string text_of(const Value* value) {
  const auto* text = value != nullptr ? std::get_if<std::string>(&value->data) : nullptr;
  return text != nullptr ? *text : std::string();
}

const Value* find(const Value::Object& object, std::string_view key) {
  for (const ValueMember& member : object) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

std::optional<double> number_of(const Value* value) {
  if (value == nullptr) return std::nullopt;
  if (const auto* integer = std::get_if<std::int64_t>(&value->data)) {
    return static_cast<double>(*integer);
  }
  const auto* number = std::get_if<double>(&value->data);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

std::vector<FlatShape> shapes_of(const FlatInstance& instance, bool has_position) {
  const std::string type = path::to_lower(instance.type);
  if (type == "heightmap")
    return {{instance.name, {}, heightmap_of(instance.properties, instance.file), std::nullopt}};
  const Value::Object* geometry = object_of(find(instance.properties, "geometry"));
  if (type != "primitive") return {};
  // MARS: `physicmode` decides; only `geometry` gives a shape its size and place.
  std::string shape = text_of(find(instance.properties, "physicmode"));
  if (geometry == nullptr && find(instance.properties, "extend") == nullptr) return {};
  if (geometry != nullptr && shape.empty()) shape = text_of(find(*geometry, "type"));
  const auto solid = primitive(shape, instance.properties);
  if (!solid) return {};
  Pose X_ES;
  const bool has_place = geometry != nullptr && (shape == "box" || shape == "sphere");
  if (!has_position && has_place) X_ES.position[2] = 0.5;
  return {{instance.name, X_ES, *solid, color_of(instance.properties)}};
}

}  // namespace smurf
