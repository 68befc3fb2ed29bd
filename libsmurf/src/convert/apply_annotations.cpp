// SPDX-License-Identifier: BSD-3-Clause
// Values of the annotations replace the values of the URDF, if a URDF can express them. Where both
// agree, nothing changes.
#include <map>
#include <set>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"
#include "convert/annotation_values.hpp"
#include "convert/passes.hpp"

namespace smurf::passes {
namespace {

class Application {
 public:
  Application(const LinkedModel& model, const UrdfExport& options, DiagnosticSink& sink,
              XmlEdits& edits)
      : model_(model), options_(options), sink_(sink), edits_(edits), values_(model) {}

  void run() {
    if (options_.apply.materials) {
      for (const MaterialAnnotation& entry : model_.annotations.materials) material(entry);
    }
    for (const Motor& motor : model_.annotations.motors) {
      const urdf::Joint* joint = values_.joint_of(motor);
      if (joint == nullptr) continue;
      if (!driven_.emplace(joint, &motor).second) {
        ambiguous(motor, *driven_[joint]);
        continue;
      }
      if (options_.apply.limits) limits(motor, *joint);
      if (options_.apply.mimic) mimic(motor, *joint);
    }
    if (options_.apply.dynamics) {
      for (const JointAnnotation& entry : model_.annotations.joints) dynamics(entry);
    }
  }

 private:
  xml::View view(xml::ElementId id) const { return edits_.view(id); }

  void ambiguous(const Motor& motor, const Motor& first) {
    if (!options_.apply.limits && !options_.apply.mimic) return;
    Diagnostic& diagnostic =
        sink_.report(rules::sml8003_ambiguous, motor.joint.span,
                     "two motors drive the joint `" + *motor.joint + "`; the first one is applied");
    diagnostic.label(first.joint.span, "the first one");
  }

  /// All definitions of the name, because readers use different ones.
  void material(const MaterialAnnotation& entry) {
    if (!values_.defines(entry) || (!entry.diffuse_color && !entry.diffuse_texture)) return;
    if (!materials_.insert(*entry.name).second) return;
    const urdf::Material* definition = values_.definition(*entry.name);
    const auto visit = [&](const urdf::Material& material) {
      if (!material.name || *material.name != *entry.name) return;
      const bool is_definition = material.rgba || material.texture;
      if (is_definition || &material == definition) define(entry, material);
    };
    for (const urdf::Material& material : model_.robot->materials) visit(material);
    for (const urdf::Link& link : model_.robot->links) {
      for (const urdf::Visual& visual : link.visuals) {
        if (visual.material) visit(*visual.material);
      }
    }
  }

  void define(const MaterialAnnotation& entry, const urdf::Material& material) {
    const xml::View element = view(material.element);
    if (entry.diffuse_color && material.rgba.value() != rgba_of(*entry.diffuse_color)) {
      std::string rgba;
      for (const double part : rgba_of(*entry.diffuse_color)) {
        rgba += (rgba.empty() ? "" : " ") + format_number(part);
      }
      set_child(element, "color", "rgba", rgba);
    }
    if (entry.diffuse_texture) {
      const std::string folder(path::parent(model_.path));
      const std::string target = places::absolute_from(options_.current_folder,
                                                       path::join(folder, *entry.diffuse_texture));
      const std::string from =
          places::absolute_from(options_.current_folder, options_.output_folder);
      if (!material.texture) {
        set_child(element, "texture", "filename", path::relative(target, from));
      }
    }
  }

  void set_child(xml::View element, std::string_view child, std::string_view attribute,
                 const std::string& value) {
    if (const xml::View known = element.child(child)) {
      edits_.set_attribute(known, attribute, value);
    } else {
      edits_.add_child(element, new_element(child, {{attribute, value}}));
    }
  }

  void limits(const Motor& motor, const urdf::Joint& joint) {
    using enum LimitValue;
    constexpr std::pair<LimitValue, std::string_view> kValues[] = {
        {lower, "lower"}, {upper, "upper"}, {effort, "effort"}, {velocity, "velocity"}};
    Attributes wanted;
    for (const auto& [value, attribute] : kValues) {
      const bool is_bound = value == lower || value == upper;
      if (is_bound && joint.type == urdf::JointType::continuous) continue;
      if (const auto number = limit_of(motor, value)) {
        wanted.emplace_back(attribute, format_number(*number));
        if (joint.limit) edits_.set_number(view(joint.limit->element), attribute, *number);
      }
    }
    const bool is_complete = limit_of(motor, effort) && limit_of(motor, velocity);
    // A limit without effort and velocity is an error to every reader.
    if (!joint.limit && is_complete) {
      edits_.add_child(view(joint.element), new_element("limit", wanted));
    }
  }

  void mimic(const Motor& motor, const urdf::Joint& joint) {
    const urdf::Joint* leader = values_.leader_of(motor);
    if (leader == nullptr || leader == &joint || !leader->name || values_.says_mimic(motor)) return;
    const double multiplier = motor.mimic_multiplier.value_or(0);  // as in MARS
    const double offset = motor.mimic_offset.value_or(0);
    if (!joint.mimic) {
      edits_.add_child(view(joint.element),
                       new_element("mimic", {{"joint", *leader->name},
                                             {"multiplier", format_number(multiplier)},
                                             {"offset", format_number(offset)}}));
      return;
    }
    const xml::View element = view(joint.mimic->element);
    edits_.set_attribute(element, "joint", *leader->name);
    if (joint.mimic->multiplier.value_or(1) != multiplier) {
      edits_.set_number(element, "multiplier", multiplier);
    }
    if (joint.mimic->offset.value_or(0) != offset) edits_.set_number(element, "offset", offset);
  }

  void dynamics(const JointAnnotation& entry) {
    const urdf::Joint* joint = values_.joint_of(entry);
    const yaml::Document* document = model_.document(entry.span.source);
    if (joint == nullptr || document == nullptr || !dynamics_.insert(joint).second) return;
    std::map<std::string_view, double> wanted;
    for (const yaml::View key : yaml::View(*document, entry.node)) {
      const auto value = dynamics_value(key.key());
      const std::optional<double> number = key.number();
      if (!value || !number || !is_quantity(*number)) continue;
      wanted.emplace(*value == DynamicsValue::damping ? "damping" : "friction", *number);
    }
    Attributes attributes;
    for (const auto& [name, number] : wanted) {
      const urdf::Dynamics known = joint->dynamics.value_or(urdf::Dynamics{});
      const Field<double>& field = name == "damping" ? known.damping : known.friction;
      if (field.value_or(0) == number) continue;
      if (joint->dynamics) edits_.set_number(view(joint->dynamics->element), name, number);
      attributes.emplace_back(name, format_number(number));
    }
    if (!joint->dynamics && !attributes.empty()) {
      edits_.add_child(view(joint->element), new_element("dynamics", attributes));
    }
  }

  const LinkedModel& model_;
  const UrdfExport& options_;
  DiagnosticSink& sink_;
  XmlEdits& edits_;
  AnnotationValues values_;
  std::map<const urdf::Joint*, const Motor*> driven_;
  std::set<std::string_view> materials_;
  std::set<const urdf::Joint*> dynamics_;
};

}  // namespace

void apply_annotations(const LinkedModel& model, const UrdfExport& options, DiagnosticSink& sink,
                       XmlEdits& edits) {
  Application(model, options, sink, edits).run();
}

}  // namespace smurf::passes
