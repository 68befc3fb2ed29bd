// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/suggest.hpp"
#include "lint/companions/controllers.hpp"

namespace smurf::rules::sml3701_controller_unknown_joint_file {
namespace {

constexpr Circumstance kSettings{"settings"};

/// A controller with the references in its section.
struct Section {
  const RosController* controller = nullptr;
  std::vector<const Reference*> references;
  std::vector<std::string_view> joints;      ///< of its key `joints`
  std::set<std::string_view> listed_joints;  ///< of all keys that list its joints
  bool has_unknown_joint = false;

  Section(const LinkedModel& model, const RosController& one) : controller(&one) {
    for (const std::string_view key : {"joints", "command_joints", "dof_names"}) {
      for (const yaml::View item : one.list(key)) listed_joints.insert(item.text());
    }
    for (const yaml::View item : one.list("joints")) {
      joints.push_back(item.text());
      has_unknown_joint = has_unknown_joint || !model.joint_index(item.text());
    }
  }

  /// Whether the robot has none of the joints of the controller, and none of a similar name: it is
  /// then for another robot.
  bool is_foreign(const LinkedModel& model) const {
    return std::none_of(references.begin(), references.end(), [&](const Reference* one) {
      return (one->is_known() && one->kind == NameKind::joint) ||
             (one->kinds == NameKind::joint && !one->is_vague &&
              near_name(one->name, model.joint_names.names()));
    });
  }
};

/// A movable joint that the section does not list and that is one edit away, also in a digit:
/// `joint3` for `joint33`. A joint of a larger robot has none, because the section lists all of
/// this one.
std::optional<std::string_view> numbered_joint(const LinkedModel& model, const Section& section,
                                               std::string_view name) {
  std::vector<std::string_view> unused;
  for (const urdf::Joint& one : model.robot->joints) {
    if (!one.name || !one.is_movable() || section.listed_joints.contains(*one.name)) continue;
    if (edit_distance(*one.name, name, 1) <= 1) unused.push_back(*one.name);
  }
  return unused.size() == 1 ? std::optional(unused.front()) : std::nullopt;
}

/// The sections of a file in its order. One section may be that of several controllers; the first
/// has the references.
std::vector<Section> sections_of(const LinkedModel& model, const ControllerFile& file,
                                 const std::vector<Reference>& references) {
  std::vector<Section> sections;
  std::map<std::pair<SourceId, std::uint32_t>, std::size_t> by_begin;
  for (const RosController& one : file.controllers) {
    if (!one.section) continue;
    const Span span = one.section.span();
    by_begin.try_emplace({span.source, span.begin}, sections.size());
    sections.emplace_back(model, one);
  }
  for (const Reference& one : references) {
    // The nearest section around it: one that is written in two parts lies around others.
    auto after = by_begin.upper_bound({one.span.source, one.span.begin});
    while (after != by_begin.begin()) {
      Section& section = sections[(--after)->second];
      const Span span = section.controller->section.span();
      if (span.source != one.span.source) break;
      if (one.span.end > span.end) continue;
      section.references.push_back(&one);
      break;
    }
  }
  return sections;
}

void check_reference_of(const LinkedModel& model, const Section& section, const Reference& one,
                        Findings& findings) {
  const RosController& controller = *section.controller;
  if (one.is_vague) {
    // `gains` and `constraints`: names of joints of the controller.
    if (section.joints.empty() || section.listed_joints.contains(one.name)) return;
    // Then it is `joints` that has another name than meant.
    if (model.joint_index(one.name) && section.has_unknown_joint) return;
    Diagnostic& found =
        findings.report(one.span, title_of(controller) + " has settings for the joint " +
                                      quoted(one.name) + ", which is not one of its joints");
    found.severity = Severity::warning;
    found.when(kSettings);
    if (const auto near = findings.suggest(one.name, section.joints)) {
      found.help("did you mean " + quoted(*near) + "?");
      found.fixes.push_back({Applicability::unsafe, {{one.span, std::string(*near)}}});
    } else {
      found.help("delete it, or add the joint to `joints`");
    }
    return;
  }
  // A name with a slash is an interface of another controller.
  if (one.is_known() || one.name.find('/') != std::string_view::npos) return;
  const std::string subject = title_of(controller);
  Diagnostic* found =
      check_reference(model, NameKind::joint, one.name, one.span, subject.c_str(), findings);
  // Variants of an arm have different numbers of joints.
  const bool is_numbered = std::any_of(model.robot->joints.begin(), model.robot->joints.end(),
                                       [&](const urdf::Joint& joint) {
                                         return joint.name && *joint.name != one.name &&
                                                differ_only_in_digits(*joint.name, one.name);
                                       });
  if (found == nullptr || !is_numbered) return;
  if (const auto near = numbered_joint(model, section, one.name)) {
    found->help("did you mean " + quoted(*near) + "?");
    found->fixes = {{Applicability::unsafe, {{one.span, std::string(*near)}}}};
    return;
  }
  found->severity = Severity::warning;
  found->when(kNumberedJoint);
}

/// One finding for a file whose joints all differ from those of the robot by a prefix.
void check_prefix(const LinkedModel& model, const std::vector<Section>& sections,
                  std::string_view prefix, Findings& findings) {
  const bool is_missing = prefix.front() == '+';  // in the file
  prefix.remove_prefix(1);
  for (const Section& section : sections) {
    for (const Reference* one : section.references) {
      if (one->kinds != NameKind::joint || one->is_known() || one->is_vague) continue;
      const std::string right = is_missing ? std::string(prefix) + std::string(one->name)
                                           : std::string(one->name.substr(prefix.size()));
      const bool is_one = is_missing || one->name.starts_with(prefix);
      if (!is_one || !model.joint_index(right)) continue;
      Diagnostic& found = findings.report(
          one->span, "the names of this file, such as " + quoted(one->name) + ", lack the prefix " +
                         quoted(prefix) + " of the joints of the robot");
      if (!is_missing) {
        found.message = "the names of this file, such as " + quoted(one->name) +
                        ", have the prefix " + quoted(prefix) +
                        ", which the joints of the robot do not have";
      }
      found.severity = Severity::warning;
      found.when(kLostPrefix);
      found.help("write " + quoted(right) +
                 " and the others in the same way, or expand the robot with another prefix");
      return;
    }
  }
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  const std::vector<Reference> references = companion_references(model, companions);
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    const std::vector<Section> sections = sections_of(model, file, references);
    if (file.companion->known_names == 0 && !file.companion->lost_prefix.empty()) {
      check_prefix(model, sections, file.companion->lost_prefix, findings);
      return;
    }
    for (const Section& section : sections) {
      if (section.is_foreign(model)) continue;
      for (const Reference* one : section.references) {
        if (one->kinds != NameKind::joint || is_placeholder(one->name)) continue;
        check_reference_of(model, section, *one, findings);
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::loses, "ignores the settings without a message",
     "ros2_controllers joint_trajectory_controller_parameters.yaml", when(kSettings)},
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not activate the controller",
     "ros2_control hardware_interface/src/resource_manager.cpp"},
};

}  // namespace

extern constinit const Rule sml3701_controller_unknown_joint{
    .id = "SML3701",
    .name = "controller-unknown-joint",
    .severity = Severity::error,
    .summary = "A controller names a joint that the robot does not have.",
    .remedy = "Correct the name.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3701_controller_unknown_joint_file
