// SPDX-License-Identifier: BSD-3-Clause
// Finds the parts of a model that a URDF cannot express. Values that the URDF already has and names
// that refer to it are not losses.
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "ast/sections.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "convert/annotation_values.hpp"
#include "convert/passes.hpp"

namespace smurf {
namespace {

/// Names of MARS's first format, which are not applied, and their replacements.
constexpr std::pair<std::string_view, std::string_view> kOldNames[] = {
    {"diffuseFront", "diffuseColor"},
    {"texturename", "diffuseTexture"},
    {"motorMaxForce", "maxEffort"},
    {"maximumVelocity", "maxSpeed"}};

/// Sections whose entries are lost in parts only; those of all others are lost as a whole.
constexpr const SectionSpec* kPartlyInUrdf[] = {
    &sections::materials, &sections::motors,  &sections::joint, &sections::sensors,
    &sections::collision, &sections::visuals, &sections::link};

class LossReport {
 public:
  LossReport(const LinkedModel& model, const UrdfExport& options, DiagnosticSink& sink)
      : model_(model),
        options_(options),
        sink_(sink),
        values_(model),
        sensors_(passes::names_in_extensions(model, "sensor")),
        driven_joints_(passes::driven_joints(model, options.actuation)) {}

  void run() {
    const Annotations& all = model_.annotations;
    for (const MaterialAnnotation& material : all.materials) of_material(material);
    for (const Motor& motor : all.motors) of_motor(motor);
    for (const JointAnnotation& joint : all.joints) of_joint(joint);
    for (const Sensor& sensor : all.sensors) of_sensor(sensor);
    for (const SectionSpec* section : all_sections()) {
      if (!is_partly_in_urdf(*section)) whole_entries(*section);
    }
    for (const CollisionAnnotation& entry : all.collisions) of_keys(entry, "collision");
    for (const VisualAnnotation& entry : all.visuals) of_keys(entry, "visual");
    for (const LinkAnnotation& entry : all.links) of_keys(entry, "link");
    for (const CustomSection& section : all.custom) of_custom(section);
    for (const CustomSection& key : model_.main.extra) of_custom(key);
    for (const xml::Attribute* limit : passes::newer_limits(model_, options_.version)) {
      lose(rules::sml8001_not_expressible, limit->name_span(), quoted(limit->name()),
           "has no place in a URDF of version " + options_.version);
    }
    if (!options_.strips_extensions) {
      for (const xml::View element : passes::replaced_transmissions(model_, options_.actuation)) {
        lose(rules::sml8004_vendor_extension, element.name_span(), quoted(element.name()),
             "is left out for ros2_control, which drives its joint");
      }
    }
    if (options_.strips_extensions) {
      for (const xml::View element : passes::extension_elements(*model_.robot)) {
        lose(rules::sml8004_vendor_extension, element.name_span(), quoted(element.name()),
             "is left out");
      }
    }
  }

 private:
  Diagnostic& lose(const Rule& rule, Span span, const std::string& what, const std::string& why) {
    return sink_.report(rule, span, what + " " + why);
  }

  static std::string title(const Annotation& entry, std::string_view kind) {
    return std::string(kind) + (entry.name ? " " + quoted(*entry.name) : "");
  }

  yaml::View view(const Annotation& entry) const {
    const yaml::Document* document = model_.document(entry.span.source);
    return document == nullptr ? yaml::View() : yaml::View(*document, entry.node);
  }

  bool is_partly_in_urdf(const SectionSpec& section) const {
    return std::find(std::begin(kPartlyInUrdf), std::end(kPartlyInUrdf), &section) !=
               std::end(kPartlyInUrdf) ||
           (options_.has_srdf && &section == &sections::poses);
  }

  void whole_entries(const SectionSpec& section) {
    for (const Annotation* entry : section.list.entries(model_.annotations)) {
      lose_entry(rules::sml8001_not_expressible, *entry, section.entry, "has no place in a URDF");
    }
  }

  void lose_entry(const Rule& rule, const Annotation& entry, std::string_view kind,
                  const std::string& why) {
    Diagnostic& loss =
        lose(rule, entry.name ? entry.name.span : entry.span, title(entry, kind), why);
    // The whole entry, not its first key.
    if (const yaml::Document* document = model_.document(entry.span.source)) {
      loss.pointer = yaml::pointer(*document, entry.node);
    }
  }

  void of_custom(const CustomSection& section) {
    // Their text is in the URDF from which urdf2smurf copied it.
    if (section.name.value == "urdf_extensions") return;
    lose(rules::sml8001_not_expressible, section.name.span, quoted(section.name.value),
         "has no place in a URDF");
  }

  /// All keys except those that name the element of the entry.
  void of_keys(const Annotation& entry, std::string_view kind) {
    for (const yaml::View key : view(entry)) {
      if (is_one_of(key.key(), {"name", "link"}) || key.is_null()) continue;
      if (key.key() == "bitmask" && options_.has_srdf) continue;
      lose_key(entry, kind, key);
    }
  }

  void lose_key(const Annotation& entry, std::string_view kind, yaml::View key) {
    lose(rules::sml8001_not_expressible, key.key_span(),
         quoted(key.key()) + " of " + title(entry, kind), "has no place in a URDF");
  }

  /// Reports a key with an old name and returns true.
  bool lose_old_name(const Annotation& entry, std::string_view kind, yaml::View key) {
    for (const auto& [old_name, name] : kOldNames) {
      if (key.key() != old_name) continue;
      lose(rules::sml8002_not_requested, key.key_span(),
           quoted(key.key()) + " of " + title(entry, kind),
           "is an old name, which is not applied; rename it to `" + std::string(name) + "`");
      return true;
    }
    return false;
  }

  void not_requested(const Annotation& entry, std::string_view kind, yaml::View key,
                     std::string_view option) {
    lose(rules::sml8002_not_requested, key.key_span(),
         quoted(key.key()) + " of " + title(entry, kind),
         "differs from the URDF, which is kept; see --apply " + std::string(option));
  }

  void of_material(const MaterialAnnotation& entry) {
    for (const yaml::View key : view(entry)) {
      if (key.key() == "name" || key.is_null() || lose_old_name(entry, "material", key)) continue;
      const bool is_color = key.key() == "diffuseColor";
      const bool is_texture = key.key() == "diffuseTexture";
      if ((!is_color && !is_texture) || !values_.defines(entry)) {
        lose_key(entry, "material", key);
      } else if (!options_.apply.materials &&
                 !(is_color ? values_.says_color(entry) : values_.says_texture(entry))) {
        not_requested(entry, "material", key, "materials");
      }
    }
  }

  void of_motor(const Motor& motor) {
    const urdf::Joint* joint = values_.joint_of(motor);
    for (const yaml::View key : view(motor)) {
      if (is_one_of(key.key(), {"name", "joint"}) || key.is_null()) continue;
      if (lose_old_name(motor, "motor", key)) continue;
      const bool is_limit = limit_value(key.key()).has_value();
      const bool is_mimic = key.key().starts_with("mimic_");
      if (key.key() == "type" && joint != nullptr && says_type(motor, *joint)) continue;
      if (joint == nullptr || (!is_limit && !is_mimic)) {
        lose_key(motor, "motor", key);
      } else if (is_limit && !values_.says_limit(motor, key.key())) {
        of_limit(motor, *joint, key);
      } else if (is_mimic && !options_.apply.mimic && !values_.says_mimic(motor)) {
        not_requested(motor, "motor", key, "mimic");
      }
    }
  }

  /// Reports a `key` whose value differs from the URDF.
  void of_limit(const Motor& motor, const urdf::Joint& joint, yaml::View key) {
    const auto value = limit_value(key.key());
    const bool is_bound = value == LimitValue::lower || value == LimitValue::upper;
    if (is_bound && joint.type == urdf::JointType::continuous) {
      lose(rules::sml8001_not_expressible, key.key_span(),
           quoted(key.key()) + " of " + title(motor, "motor"),
           "has no place in a URDF: a continuous joint has no bounds");
    } else if (!options_.apply.limits) {
      not_requested(motor, "motor", key, "limits");
    }
  }

  bool says_type(const Motor& motor, const urdf::Joint& joint) const {
    if (!options_.strips_extensions && driven_joints_.contains(*joint.name)) return true;
    const bool follows = motor.mimic_motor.has_value();
    return options_.actuation == Actuation::transmission ||
           (options_.actuation == Actuation::ros2_control && !follows);
  }

  void of_sensor(const Sensor& sensor) {
    // A sensor that is already in the URDF, as an extension, is not written twice.
    if (!options_.strips_extensions && sensor.name && sensors_.contains(*sensor.name)) return;
    const std::string_view type = passes::gazebo_type(sensor);
    if (type.empty()) {
      lose_entry(rules::sml8001_not_expressible, sensor, "sensor", "has no place in a URDF");
    } else if (!options_.adds_gazebo_sensors) {
      lose_entry(rules::sml8002_not_requested, sensor, "sensor",
                 "is not written; see --sensors gazebo");
    } else if (!sensor.name || passes::gazebo_carrier(model_, sensor).empty()) {
      lose_entry(rules::sml8001_not_expressible, sensor, "sensor",
                 "is not written: it lacks a name, or a link or joint that carries it");
    } else {
      for (const yaml::View key : view(sensor)) {
        if (key.is_null() || passes::gazebo_says(sensor, key.key())) continue;
        lose(rules::sml8001_not_expressible, key.key_span(),
             quoted(key.key()) + " of " + title(sensor, "sensor"),
             "has no place in a sensor of Gazebo");
      }
    }
  }

  void of_joint(const JointAnnotation& entry) {
    for (const yaml::View key : view(entry)) {
      if (is_one_of(key.key(), {"name", "type", "parent", "child"}) || key.is_null()) continue;
      const bool is_spring =
          is_one_of(key.key(), {"springStiffness", "spring_const_constraint_axis1"});
      if (is_spring && key.number() == 0.0) continue;  // no spring, as in a URDF
      const auto said = values_.says_dynamics(entry, key);
      if (!said) {
        lose_key(entry, "joint", key);
      } else if (options_.apply.dynamics) {
        only_first(entry, key);
      } else if (!*said) {
        not_requested(entry, "joint", key, "dynamics");
      }
    }
  }

  /// MARS has two keys for damping and uses the last; the URDF gets the first.
  void only_first(const Annotation& entry, yaml::View key) {
    const auto place = std::pair(*entry.name, *dynamics_value(key.key()));
    const auto [first, is_new] = dynamics_.emplace(place, key);
    if (is_new || first->second.number() == key.number()) return;
    lose(rules::sml8003_ambiguous, key.key_span(),
         quoted(key.key()) + " of " + title(entry, "joint"),
         "differs from " + quoted(first->second.key()) + ", which is applied")
        .label(first->second.key_span(), "this one");
  }

  const LinkedModel& model_;
  const UrdfExport& options_;
  DiagnosticSink& sink_;
  AnnotationValues values_;
  std::set<std::string_view> sensors_, driven_joints_;  ///< names in the URDF's extensions
  std::map<std::pair<std::string, DynamicsValue>, yaml::View> dynamics_;  ///< by joint; applied
};

}  // namespace

void report_losses(const LinkedModel& model, const UrdfExport& options, DiagnosticSink& sink) {
  if (model.robot) LossReport(model, options, sink).run();
}

}  // namespace smurf
