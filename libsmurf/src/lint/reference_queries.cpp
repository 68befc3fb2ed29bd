// SPDX-License-Identifier: BSD-3-Clause
#include "lint/reference_queries.hpp"

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "ast/sections.hpp"
#include "base/words.hpp"

namespace smurf {
namespace {

bool is_in_yaml(const Reference& reference) {
  return reference.notation == Reference::Notation::yaml ||
         reference.notation == Reference::Notation::yaml_key;
}

/// The name of the entry, under any key.
std::string_view name_of(const AnnotationPlace& place) {
  if (place.section == "submodels") return place.entry.key();
  const bool is_mechanism = place.section == "submechanisms" || place.section == "exoskeletons";
  const yaml::View name = place.entry.find(is_mechanism ? "contextual_name" : "name");
  return name && name.is_scalar() ? name.text() : std::string_view();
}

/// The noun for an entry in messages: "motor", but "collision entry", because "collision" alone
/// means the element of the URDF.
std::string noun_of(const SectionSpec& section) {
  if (&section == &sections::poses) return "joint pose";
  const bool is_of_urdf = &section == &sections::collision || &section == &sections::visuals;
  return std::string(section.entry) + (is_of_urdf ? " entry" : "");
}

bool is_first(yaml::View entry) {
  return entry.document().nodes[static_cast<std::size_t>(entry.id())].position() == 0;
}

/// The effect of an unknown name on readers depends on the entry.
std::string_view construct_of(const LinkedModel& model, const AnnotationPlace& place) {
  if (place.section == "collision" && place.key == "link") {
    const yaml::View name = place.entry.find("name");
    const bool is_known = name && names(model, NameKind::collision).contains(name.text());
    return is_known ? "known-collision" : "";
  }
  if (place.section == "motors" && place.key == "joint") {
    return is_first(place.entry) ? "" : "later-motor";
  }
  if (place.section != "sensors" || place.key != "link") return {};
  const yaml::View type = place.entry.find("type");
  const std::string_view name = type && type.is_scalar() ? type.text() : std::string_view();
  if (is_one_of(name, {"Joint6DOF", "CameraSensor", "RaySensor", "RotatingRaySensor",
                       "MultiLevelLaserRangeFinder", "ScanningSonar"})) {
    return "on-its-link";
  }
  return is_one_of(name, {"NodeIMU", "IMU", "NodeContact", "NodeContactForce"}) ? "" : "of-others";
}

}  // namespace

AnnotationPlace annotation_place(const LinkedModel& model, const Reference& reference) {
  const yaml::Document* document =
      is_in_yaml(reference) ? model.document(reference.span.source) : nullptr;
  if (document == nullptr) return {};
  std::vector<yaml::NodeId> above;  // from the name to the section
  for (yaml::NodeId id{reference.place}; id != document->root && id != yaml::kNoNode;
       id = document->nodes[static_cast<std::size_t>(id)].parent) {
    above.push_back(id);
  }
  if (above.empty()) return {};
  const yaml::View value(*document, above.back());
  const SectionSpec* section = find_section(value.key());
  if (section == nullptr) return {};
  above.pop_back();
  AnnotationPlace place{section->name, {}, value};
  const bool is_one = section->form == SectionForm::list_or_mapping && value.is_mapping();
  if (!is_one && !above.empty()) {
    place.entry = yaml::View(*document, above.back());
    above.pop_back();
  }
  if (!above.empty()) place.key = yaml::View(*document, above.back()).key();
  return place;
}

Span place_of(const Reference& reference) {
  const bool is_alias =
      reference.span.begin >= reference.text.end || reference.span.end <= reference.text.begin;
  const std::uint32_t quotes =
      reference.text.end - reference.text.begin - (reference.span.end - reference.span.begin);
  const bool is_whole = !is_alias && reference.notation == Reference::Notation::yaml && quotes <= 2;
  return is_whole ? reference.text : reference.span;
}

xml::View element_of(const LinkedModel& model, const Reference& reference) {
  if (is_in_yaml(reference) || !model.robot) return {};
  return {model.robot->document, xml::ElementId{reference.place}};
}

void withhold_fix(Diagnostic* diagnostic, std::string_view name) {
  if (diagnostic == nullptr) return;
  std::erase_if(diagnostic->fixes, [&](const Fix& fix) {
    return std::any_of(fix.edits.begin(), fix.edits.end(),
                       [&](const Edit& edit) { return edit.text == name; });
  });
}

std::string_view other_link(xml::View end) {
  const xml::View other = end.parent().child(end.name() == "child" ? "parent" : "child");
  const xml::Attribute* link = other ? other.attribute("link") : nullptr;
  return link != nullptr ? link->value() : std::string_view();
}

std::string subject_of(const AnnotationPlace& place) {
  const SectionSpec* section = find_section(place.section);
  if (section == nullptr) return "this entry";
  if (place.key == "name") return "this " + std::string(section->entry) + " entry";
  // In MARS 2, `link` is the name.
  if (section == &sections::link && place.key == "link") return "this link entry";
  const std::string_view name = name_of(place);
  const std::string noun = noun_of(*section);
  return name.data() == nullptr ? "this " + noun : noun + " " + quoted(name);
}

std::string subject_of(xml::View joint) {
  const xml::Attribute* name = joint ? joint.attribute("name") : nullptr;
  return name != nullptr ? "joint " + quoted(name->value()) : "a joint without name";
}

Diagnostic* report_unknown(const LinkedModel& model, const Reference& reference,
                           Findings& findings) {
  const AnnotationPlace place = annotation_place(model, reference);
  const std::string subject = subject_of(place);
  Diagnostic* diagnostic = check_reference(model, reference.kind, reference.name,
                                           place_of(reference), subject.c_str(), findings);
  if (diagnostic != nullptr) diagnostic->construct += construct_of(model, place);
  return diagnostic;
}

void report_unknown(const LinkedModel& model, NameKind kind, Findings& findings,
                    const std::function<bool(const AnnotationPlace&)>& is_passed_over) {
  for (const Reference& one : findings.doubtful_references()) {
    if (one.kind != kind || !is_in_yaml(one) || one.is_known() || one.is_vague) continue;
    const AnnotationPlace place = annotation_place(model, one);
    if (place.section == "poses" || (is_passed_over && is_passed_over(place))) continue;
    report_unknown(model, one, findings);
  }
}

}  // namespace smurf
