// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/environment.hpp"

#include <string_view>

namespace smurf::load_check {
namespace {

const Value* find(const Value::Object& object, std::string_view key) {
  for (const ValueMember& member : object) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

const Value* find(const Value* value, std::string_view key) {
  const auto* object = value != nullptr ? std::get_if<Value::Object>(&value->data) : nullptr;
  return object != nullptr ? find(*object, key) : nullptr;
}

double number(const Value* value, double fallback) {
  if (value == nullptr) return fallback;
  if (const auto* real = std::get_if<double>(&value->data)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&value->data)) {
    return static_cast<double>(*whole);
  }
  return fallback;
}

std::string_view text(const Value* value) {
  const auto* found = value != nullptr ? std::get_if<std::string>(&value->data) : nullptr;
  return found != nullptr ? std::string_view(*found) : std::string_view();
}

bool is_true(const Value* value) {
  const auto* found = value != nullptr ? std::get_if<bool>(&value->data) : nullptr;
  return found != nullptr && *found;
}

/// The shape of a primitive with MARS's defaults (primitives.cpp:115-150), which builds no others.
std::optional<Shape> primitive(const Value::Object& properties) {
  const Value* extend = find(properties, "extend");
  const auto extent = [&](std::string_view axis, double fallback) {
    return number(find(extend, axis), fallback);
  };
  const std::string_view type = text(find(find(properties, "geometry"), "type"));
  if (type == "plane") return PlaneShape{};
  if (type == "box") {
    return BoxShape{{extent("x", 1), extent("y", 1), extent("z", 1)}};
  }
  if (type == "sphere") return SphereShape{extent("x", 0.5)};
  return std::nullopt;
}

bool has_extent(const Shape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->size.minCoeff() > 0;
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) return sphere->radius > 0;
  return true;
}

}  // namespace

std::size_t add_environment(const LinkedScene& scene, const FlatScene& flat, Plan& plan,
                            DiagnosticSink&) {
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < flat.instances.size(); ++i) {
    const FlatInstance& instance = flat.instances[i];
    if (instance.model) continue;
    std::optional<Shape> shape;
    const bool stands = !is_true(find(instance.properties, "movable"));
    if (instance.type == "primitive" && stands) shape = primitive(instance.properties);
    if (!shape || !has_extent(*shape) || !instance.X_WE) {
      ++left_out;
      continue;
    }
    ShapePlan& added = plan.shapes.emplace_back();
    added.name = "entity `" + instance.path + "`";
    added.place = smurf::place_of(scene.entity(scene.instances[i]));
    added.body = kEnvironment;
    added.X_WS = *instance.X_WE;
    added.shape = std::move(*shape);
  }
  return left_out;
}

}  // namespace smurf::load_check
