// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

#include <algorithm>

#include "ast/sections.hpp"
#include "ast/urdf_numbers.hpp"
#include "ast/urdf_schema.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"
#include "lint/reference_queries.hpp"

namespace smurf {
namespace {

Span visual_or_collision(const LinkedModel& model, NameKind kind, std::string_view name,
                         std::uint32_t link) {
  if (kind == NameKind::visual) {
    for (const urdf::Visual& visual : model.robot->links[link].visuals) {
      if (visual.name && *visual.name == name) return visual.name.span;
    }
  }
  for (const urdf::Collision& collision : model.robot->links[link].collisions) {
    if (collision.name && *collision.name == name) return collision.name.span;
  }
  return {};
}

/// The place of an attribute or child with a name similar to `name`; empty if there is none.
Span find_slip(const LinkedModel& model, xml::ElementId element, std::string_view name) {
  const xml::View view(model.robot->document, element);
  const std::string_view known[] = {name};
  for (const xml::Attribute& at : view.attributes()) {
    if (urdf::meant_name(at.name(), known)) return at.name_span();
  }
  for (const xml::View child : view) {
    if (urdf::meant_name(child.name(), known)) return child.name_span();
  }
  return {};
}

/// The missing entry may have no name or a wrong name.
template <class Entries>
bool are_all_named(const Entries& entries, const NameTable& names) {
  return names.names().size() == entries.size() && !names.contains("");
}

}  // namespace

const NameTable& names(const LinkedModel& model, NameKind kind) { return *model.names(kind); }

Span definition(const LinkedModel& model, NameKind kind, std::string_view name) {
  const auto index = names(model, kind).find(name);
  if (!index) return {};
  switch (kind) {
  case NameKind::link: return model.robot->links[*index].name.span;
  case NameKind::joint: return model.robot->joints[*index].name.span;
  case NameKind::visual:
  case NameKind::collision: return visual_or_collision(model, kind, name, *index);
  case NameKind::motor: return model.annotations.motors[*index].name.span;
  case NameKind::sensor: return model.annotations.sensors[*index].name.span;
  default: return {};
  }
}

bool can_judge(const LinkedModel& model, NameKind kind) {
  const Annotations& all = model.annotations;
  if (kind == NameKind::motor) {
    return model.is_complete && are_all_named(all.motors, model.motor_names);
  }
  if (kind == NameKind::sensor) {
    return model.is_complete && are_all_named(all.sensors, model.sensor_names);
  }
  return model.robot.has_value();
}

Diagnostic* check_reference(const LinkedModel& model, NameKind kind, std::string_view name,
                            Span place, const Subject& subject, Findings& findings) {
  return check_reference(model, kind, name, place, subject, findings, Meanings{});
}

Span within_quotes(const LinkedModel& model, Span place) {
  const yaml::Document* document = model.document(place.source);
  if (document == nullptr) return place;
  const yaml::NodeId id = yaml::node_at(*document, place.begin);
  if (id == yaml::kNoNode) return place;
  const yaml::Node& node = document->nodes[static_cast<std::size_t>(id)];
  const bool is_quoted =
      node.style == yaml::Style::single_quoted || node.style == yaml::Style::double_quoted;
  if (!is_quoted || node.span != place) return place;
  return {place.source, place.begin + 1, place.end - 1};
}

std::string Subject::text() const {
  if (name_ == nullptr) return std::string(words_);
  return *name_ ? std::string(words_) + " " + quoted(**name_) : "this " + std::string(words_);
}

Subject subject(const urdf::Joint& joint) {
  return joint.name ? Subject("joint", joint.name) : "a joint without name";
}

void for_each_link(const LinkedModel& model, const std::function<void(const urdf::Link&)>& visit) {
  if (!model.robot) return;
  for (const urdf::Link& link : model.robot->links) visit(link);
}

void for_each_joint(const LinkedModel& model,
                    const std::function<void(const urdf::Joint&)>& visit) {
  if (!model.robot) return;
  for (const urdf::Joint& joint : model.robot->joints) visit(joint);
}

void for_each_material(const LinkedModel& model,
                       const std::function<void(const urdf::Material&)>& visit) {
  if (!model.robot) return;
  for (const urdf::Material& material : model.robot->materials) visit(material);
  for (const urdf::Link& link : model.robot->links) {
    for (const urdf::Visual& visual : link.visuals) {
      if (visual.material) visit(*visual.material);
    }
  }
}

std::optional<NameKind> sensor_target(std::string_view type) {
  const NameKinds kinds = sections::measured_by(type);
  return kinds.empty() ? std::nullopt : std::optional(kinds.first());
}

bool is_section_name(std::string_view key) {
  const std::vector<std::string_view> names = section_names();
  return std::find(names.begin(), names.end(), key) != names.end();
}

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  numbers.reserve(3);
  std::size_t at = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    if (const auto number = parse_number(word)) numbers.push_back(*number);
  }
  return numbers;
}

std::string title(const urdf::Link& link) {
  return link.name ? "link " + quoted(*link.name) : "a link without name";
}

std::string title(const urdf::Joint& joint) { return subject(joint); }

Span tag_name(const LinkedModel& model, xml::ElementId element) {
  return xml::View(model.robot->document, element).name_span();
}

Span inertia_place(const LinkedModel& model, const urdf::Inertial& inertial) {
  const xml::View element(model.robot->document, inertial.element);
  const xml::View inertia = element.child("inertia");
  return inertia ? inertia.name_span() : element.name_span();
}

Span name_place(const LinkedModel& model, const urdf::Link& link) {
  return link.name.span.empty() ? tag_name(model, link.element) : link.name.span;
}

Span name_place(const LinkedModel& model, const urdf::Joint& joint) {
  return joint.name.span.empty() ? tag_name(model, joint.element) : joint.name.span;
}

bool has_only_comments(const xml::Document& document) {
  const xml::View root(document, document.root);
  return root.begin() == root.end() && root.attributes().empty() && !document.comments.empty();
}

bool has_slip(const LinkedModel& model, xml::ElementId element, std::string_view name) {
  return !find_slip(model, element, name).empty();
}

bool is_slip(const LinkedModel& model, xml::ElementId element, std::string_view name,
             Findings& findings) {
  const Span slip = find_slip(model, element, name);
  if (!slip.empty()) findings.add_consequence(slip);
  return !slip.empty();
}

}  // namespace smurf
