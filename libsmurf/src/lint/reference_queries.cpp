// SPDX-License-Identifier: BSD-3-Clause
#include "lint/reference_queries.hpp"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <set>
#include <vector>

#include "ast/sections.hpp"
#include "ast/urdf_numbers.hpp"
#include "base/findings/cases.hpp"
#include "base/ranges.hpp"
#include "base/text/edits.hpp"
#include "base/text/lists.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/model_answers.hpp"

namespace smurf {
namespace {

/// With more unknown names than this, they are no slips, and looking for unused names for each of
/// them would take too long.
constexpr std::size_t kMostSlips = 200;
constexpr NameKind kKinds[] = {NameKind::link,      NameKind::joint,    NameKind::visual,
                               NameKind::collision, NameKind::material, NameKind::motor,
                               NameKind::sensor};

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

/// The movable joints that no motor drives. Many motors have the name of their joint.
UnusedNames joints_without_motor(const LinkedModel& model, std::string_view motor) {
  std::set<std::string_view> driven;
  for (const Motor& one : model.annotations.motors) {
    if (one.joint) driven.insert(*one.joint);
  }
  UnusedNames unused{{}, motor, "which no motor drives"};
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.name && joint.is_movable() && !driven.contains(*joint.name)) {
      unused.names.push_back(*joint.name);
    }
  });
  return unused;
}

/// What the entry with an unknown name is to readers; null if that makes no difference.
const Circumstance* case_of(const LinkedModel& model, const AnnotationPlace& place) {
  if (place.section == "collision" && place.key == "link") {
    const yaml::View name = place.entry.find("name");
    const bool is_known = name && names(model, NameKind::collision).contains(name.text());
    return is_known ? &cases::kKnownCollision : nullptr;
  }
  if (place.section == "motors" && place.key == "joint") {
    return is_first(place.entry) ? nullptr : &cases::kLaterMotor;
  }
  if (place.section != "sensors" || place.key != "link") return nullptr;
  const yaml::View type = place.entry.find("type");
  const std::string_view name = type && type.is_scalar() ? type.text() : std::string_view();
  if (is_one_of(name, {"Joint6DOF", "CameraSensor", "RaySensor", "RotatingRaySensor",
                       "MultiLevelLaserRangeFinder", "ScanningSonar"})) {
    return &cases::kOnItsLink;
  }
  const bool is_of_links = is_one_of(name, {"NodeIMU", "IMU", "NodeContact", "NodeContactForce"});
  return is_of_links ? nullptr : &cases::kOfOthers;
}

/// The name that a misspelt name probably means; empty if there is none.
struct Guess {
  std::string_view name;
  std::string reason;  ///< why it is not the nearest name: ", which no motor drives"
  bool has_fix = true;
};

Guess guess_name(std::string_view name, std::span<const std::string_view> all,
                 const Meanings& meanings, Findings& findings) {
  const auto among = [&](std::span<const std::string_view> known) {
    const auto others = without_own(name, meanings.own, known);
    const auto near = findings.suggest(name, others ? std::span(*others) : known);
    if (!near || differ_only_in_digits(name, *near)) return std::string_view();
    return meanings.is_impossible && meanings.is_impossible(*near) ? std::string_view() : *near;
  };
  const std::string_view nearest = among(all);
  if (!meanings.unused || findings.answers().doubtful_references().size() > kMostSlips)
    return {nearest, {}};
  const UnusedNames likely = meanings.unused();
  std::string_view meant = among(likely.names);
  if (meant.empty() && ranges::contains(likely.names, likely.own)) meant = likely.own;
  // Another use of the nearest name would be another mistake.
  if (meant.empty()) return {nearest, {}, false};
  return {meant, meant == nearest ? std::string() : ", " + likely.reason};
}

}  // namespace

Diagnostic* check_reference(const LinkedModel& model, NameKind kind, std::string_view name,
                            Span place, const Subject& subject, Findings& findings,
                            const Meanings& meanings) {
  if (!can_judge(model, kind) || names(model, kind).contains(name)) return nullptr;
  if (is_xacro(name)) return nullptr;  // SML1009
  const std::string kind_name(to_string(kind));
  Diagnostic& diagnostic =
      findings.report(place, subject + " names the " + kind_name + " " + quoted(name) +
                                 ", which the model does not have");
  for (const NameKind other : kKinds) {
    // A motor often has the name of its joint, so such a motor is not suggested for a joint.
    const bool is_annotation = other == NameKind::motor || other == NameKind::sensor;
    if (other == kind || is_annotation || !names(model, other).contains(name)) continue;
    diagnostic.message = subject + " needs a " + kind_name + ", but " + quoted(name) + " is a " +
                         std::string(to_string(other));
    const Span defined = definition(model, other, name);
    if (!defined.empty()) {
      diagnostic.label(defined, "the " + std::string(to_string(other)) + " is defined here");
    }
    return &diagnostic;
  }
  diagnostic.caret = "no such " + kind_name;
  if (!model.urdf_path.empty() && kind != NameKind::motor && kind != NameKind::sensor) {
    diagnostic.caret += " in `" + model.urdf_path + "`";
  }
  const Guess guess = guess_name(name, names(model, kind).names(), meanings, findings);
  if (guess.name.empty()) {
    const auto all = names(model, kind).names();
    std::vector<std::string_view> possible;
    for (const std::string_view one : all.size() > kMostValues ? decltype(all)() : all) {
      const bool is_impossible =
          one == meanings.own || (meanings.is_impossible && meanings.is_impossible(one));
      if (!is_impossible) possible.push_back(one);
    }
    if (!possible.empty()) diagnostic.help("correct the name: write " + choices(possible));
    return &diagnostic;
  }
  diagnostic.help("did you mean " + quoted(guess.name) + guess.reason + "?");
  if (guess.has_fix && fits_everywhere(guess.name)) {
    diagnostic.fixes.push_back(
        {Applicability::unsafe, {{within_quotes(model, place), std::string(guess.name)}}});
  }
  const Span defined = definition(model, kind, guess.name);
  if (!defined.empty()) diagnostic.label(defined, quoted(guess.name) + " is defined here");
  return &diagnostic;
}

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
  Meanings meanings;
  if (place.section == "motors" && place.key == "joint") {
    meanings.unused = [&] { return joints_without_motor(model, name_of(place)); };
  }
  // A motor may mimic another one only.
  if (place.section == "motors" && reference.kind == NameKind::motor) {
    meanings.own = name_of(place);
  }
  Diagnostic* diagnostic =
      check_reference(model, reference.kind, reference.name, place_of(reference), subject.c_str(),
                      findings, meanings);
  const Circumstance* one = case_of(model, place);
  if (diagnostic != nullptr && one != nullptr) diagnostic->when(*one);
  return diagnostic;
}

namespace {

/// One finding for all names of motors, when the model has none.
void tell_that_there_is_no_motor(Diagnostic& diagnostic, const LinkedModel& model,
                                 Findings& findings) {
  const auto all = findings.answers().doubtful_references();
  const auto count = std::count_if(all.begin(), all.end(), [](const Reference& one) {
    return one.kind == NameKind::motor && is_in_yaml(one) && !one.is_known() && !one.is_vague;
  });
  diagnostic.note("the model has no motor" +
                  (count > 1 ? ", and " + std::to_string(count) + " names of motors" : ""));
  if (model.robot && !model.robot->joints.empty()) {
    diagnostic.help("write the motors of the joints in the section `motors`");
  }
}

}  // namespace

void report_unknown(const LinkedModel& model, NameKind kind, Findings& findings,
                    const std::function<bool(const AnnotationPlace&)>& is_passed_over) {
  for (const Reference& one : findings.answers().doubtful_references()) {
    if (one.kind != kind || !is_in_yaml(one) || one.is_known() || one.is_vague) continue;
    const AnnotationPlace place = annotation_place(model, one);
    if (place.section == "poses" || (is_passed_over && is_passed_over(place))) continue;
    Diagnostic* diagnostic = report_unknown(model, one, findings);
    if (kind == NameKind::motor && model.annotations.motors.empty() && diagnostic != nullptr) {
      tell_that_there_is_no_motor(*diagnostic, model, findings);
      return;
    }
  }
}

}  // namespace smurf
