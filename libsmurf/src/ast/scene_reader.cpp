// SPDX-License-Identifier: BSD-3-Clause
// Reads scenes and assemblies. Opens no other files, resolves no names and composes no poses.
#include "ast/scene_reader.hpp"

#include <algorithm>
#include <cmath>

#include "ast/model_reader.hpp"
#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "ast/wrong_type.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"

namespace smurf {
namespace {

constexpr std::string_view kWxyz[] = {"w", "x", "y", "z"};

class RotationReader {
 public:
  explicit RotationReader(DiagnosticSink& sink) : sink_(sink) {}

  Rotation read(yaml::View value) {
    if (value.is_null()) return rotation_;
    rotation_.span = value.place();
    rotation_.form = RotationForm::invalid;
    rotation_.is_mapping = value.is_mapping();
    if (value.is_mapping()) {
      read_mapping(value);
    } else if (value.is_sequence()) {
      read_list(value);
    } else if (read_number(value, 0)) {
      rotation_.form = RotationForm::yaw;
    }
    check_length();
    return rotation_;
  }

 private:
  bool read_number(yaml::View value, std::size_t index) {
    const std::optional<double> number = value.number();
    if (number && std::isfinite(*number)) {
      rotation_.values[index] = *number;
      return true;
    }
    report_wrong_type(cases::kValueWanted, value,
                      "`rotation` must be numbers, not " + describe(value), sink_);
    return false;
  }

  void read_list(yaml::View list) {
    const std::size_t size = list.size();
    if (size != 1 && size != 3 && size != 4) {
      Diagnostic& diagnostic = sink_.report(rules::sml5002_rotation_length, list.span(),
                                            "`rotation` has " + std::to_string(size) +
                                                " numbers, which no reader understands");
      diagnostic.help(
          "write one number (degrees about z), three (degrees about x, y, z) or four (quaternion "
          "w, x, y, z)");
      return;
    }
    bool is_sound = true;
    std::size_t index = 0;
    for (const yaml::View item : list) is_sound = read_number(item, index++) && is_sound;
    if (!is_sound) return;
    rotation_.form = size == 1   ? RotationForm::yaw
                     : size == 3 ? RotationForm::euler
                                 : RotationForm::quaternion;
  }

  void read_mapping(yaml::View mapping) {
    bool is_sound = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const yaml::View component = mapping.find(kWxyz[i]);
      if (!component) {
        Diagnostic& diagnostic =
            sink_.report(rules::sml5002_rotation_length, mapping.span(),
                         "`rotation` is a mapping without `" + std::string(kWxyz[i]) + "`");
        diagnostic.help("a mapping is a quaternion with `w`, `x`, `y`, `z`; angles are a list");
        return;
      }
      is_sound = read_number(component, i) && is_sound;
    }
    if (is_sound) rotation_.form = RotationForm::quaternion;
  }

  /// The direction in four dimensions decides the rotation; a rule reports a length other than 1.
  void check_length() {
    if (rotation_.form != RotationForm::quaternion) return;
    const auto& [w, x, y, z] = rotation_.values;
    const double length = hypotenuse(hypotenuse(w, x), hypotenuse(y, z));
    if (length > 1e-6 && length < 1e150) return;
    rotation_.form = RotationForm::invalid;
    sink_.report(rules::sml5003_zero_quaternion, rotation_.span,
                 "the quaternion has the length " + format_rounded(length) +
                     ", so it is not a rotation");
  }

  DiagnosticSink& sink_;
  Rotation rotation_;
};

bool has_member(std::string_view key) {
  if (key == "rotation" || key == "poses") return true;
  for (const Key<Entity>& row : entity_keys()) {
    if (row.spec.name == key) return true;
  }
  return false;
}

CustomSection keep(yaml::View value) {
  return {{std::string(value.key()), value.key_span()}, value.id(), value.span()};
}

}  // namespace

Entity read_entity(yaml::View mapping, EntityList list, DiagnosticSink& sink) {
  Entity entity;
  entity.list = list;
  entity.head = mapping.span();
  read_entry(entity_keys(), {all_entity_keys()}, mapping, entity, "entity", sink);
  bool is_first = true;
  for (const yaml::View value : mapping) {
    if (is_first) entity.head = value.key_span();
    is_first = false;
    if (!has_member(value.key())) entity.extra.push_back(keep(value));
  }
  if (const yaml::View position = mapping.find("position")) {
    entity.position_is_mapping = position.is_mapping();
  }
  if (const yaml::View rotation = mapping.find("rotation")) {
    entity.rotation = RotationReader(sink).read(rotation);
  }
  if (const yaml::View poses = mapping.find("poses"); poses && poses.is_sequence()) {
    Annotations annotations;
    read_sections(
        mapping, [](std::string_view key) { return key != "poses"; }, annotations, sink);
    entity.poses = std::move(annotations.poses);
  }
  return entity;
}

namespace {

void read_entities(yaml::View value, EntityList list, std::size_t most, Scene& scene,
                   DiagnosticSink& sink) {
  if (value.is_null()) return;
  const std::string key(value.key());
  if (!value.is_sequence()) {
    Diagnostic& diagnostic =
        sink.report(rules::sml4001_wrong_type, value.key_span(),
                    "`" + key + "` contains " + describe(value) + " instead of a list of entities");
    const bool is_entity = value.is_mapping() && value.find("file") && value.find("type");
    diagnostic.when(cases::kEntityWanted).when(is_entity ? cases::kIsEntity : cases::kIsList);
    diagnostic.help("begin every entity with `- name:`");
    return;
  }
  scene.entities.reserve(std::min(scene.entities.size() + value.size(), most));
  for (const yaml::View item : value) {
    if (scene.entities.size() >= most) return;
    if (item.is_mapping()) {
      scene.entities.push_back(read_entity(item, list, sink));
    } else {
      Diagnostic& diagnostic = report_wrong_type(
          cases::kEntityWanted, item,
          "an entry of `" + key + "` must be a mapping, not " + describe(item), sink);
      if (item.is_scalar()) diagnostic.help("write `{name: NAME, file: FILE}`");
    }
  }
}

std::optional<Physics> read_physics(yaml::View value, DiagnosticSink& sink) {
  if (!value || value.is_null()) return std::nullopt;
  if (!value.is_mapping()) {
    report_wrong_type(cases::kMappingWanted, value,
                      "`physics` must be a mapping, not " + describe(value), sink);
    return std::nullopt;
  }
  Physics physics;
  read_entry(physics_keys(), {all_physics_keys()}, value, physics, "physics", sink);
  if (const yaml::View ode = value.find("ode"); ode && ode.is_mapping()) {
    DiagnosticSink already_reported;
    read_keys(ode_keys(), {}, ode, physics, "ode", already_reported);
  }
  return physics;
}

void read_environment(yaml::View value, Scene& scene, DiagnosticSink& sink) {
  if (!value || value.is_null()) return;
  if (!value.is_mapping()) {
    report_wrong_type(cases::kMappingWanted, value,
                      "`environment` must be a mapping, not " + describe(value), sink);
    return;
  }
  scene.environment = value.id();
  check_keys(environment_keys(), value, "environment", sink);
}

constexpr std::string_view kTaken[] = {"smurfs",  "entities",    "smurfa",
                                       "physics", "environment", "lights"};

bool is_taken(std::string_view key) {
  for (const std::string_view taken : kTaken) {
    if (key == taken) return true;
  }
  return false;
}

}  // namespace

std::optional<Scene> read_scene(const yaml::Document& document, DiagnosticSink& sink,
                                std::size_t most_entities) {
  const yaml::View root = document.view();
  if (!root || !root.is_mapping()) {
    const Span place = root ? root.span() : Span{document.source, 0, 0};
    Diagnostic& diagnostic =
        sink.report(rules::sml2011_root_not_mapping, place,
                    "the scene contains " + (root ? describe(root) : "nothing") +
                        " instead of keys and values");
    if (root && root.is_sequence()) diagnostic.help("write `entities:` above the list");
    return std::nullopt;
  }
  Scene scene;
  constexpr EntityList kLists[] = {EntityList::smurfs, EntityList::entities, EntityList::smurfa};
  for (const EntityList list : kLists) {
    const yaml::View value = root.find(kTaken[static_cast<std::size_t>(list)]);
    if (value) read_entities(value, list, most_entities, scene, sink);
  }
  scene.physics = read_physics(root.find("physics"), sink);
  read_environment(root.find("environment"), scene, sink);
  if (root.find("lights")) {
    Annotations annotations;
    read_sections(
        root, [](std::string_view key) { return key != "lights"; }, annotations, sink);
    scene.lights = std::move(annotations.lights);
  }
  for (const yaml::View value : root) {
    if (is_taken(value.key())) continue;
    if (const KeySpec* spec = find_key({scene_keys()}, value.key()))
      read_value(*spec, value, {}, sink);
    scene.extra.push_back(keep(value));
  }
  return scene;
}

Span place_of(const Entity& entity) { return entity.name.written ? entity.name.span : entity.head; }

Quaternion to_quaternion(const Rotation& rotation) {
  const auto& [a, b, c, d] = rotation.values;
  switch (rotation.form) {
  case RotationForm::yaw: return from_rpy_degrees({0, 0, a});
  case RotationForm::euler: return from_rpy_degrees({a, b, c});
  case RotationForm::quaternion: return normalized({a, b, c, d});
  case RotationForm::absent:
  case RotationForm::invalid: break;
  }
  return {};
}

}  // namespace smurf
