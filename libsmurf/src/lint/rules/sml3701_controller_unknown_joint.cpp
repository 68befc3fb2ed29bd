// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/text/suggest.hpp"
#include "lint/companions/controllers.hpp"

namespace smurf::rules::sml3701_controller_unknown_joint_file {
namespace {

constexpr Circumstance kNumbered{"numbered"};
constexpr Circumstance kSettings{"settings"};

bool is_in(Span inner, Span outer) {
  return inner.source == outer.source && outer.begin <= inner.begin && inner.end <= outer.end;
}

/// The controller whose section contains a place; null if there is none.
const RosController* controller_at(const ControllerFile& file, Span place) {
  const auto found =
      std::find_if(file.controllers.begin(), file.controllers.end(), [&](const RosController& one) {
        return one.section && is_in(place, one.section.span());
      });
  return found == file.controllers.end() ? nullptr : &*found;
}

bool lists(const RosController& controller, std::string_view joint) {
  for (const std::string_view key : {"joints", "command_joints", "dof_names"}) {
    const std::vector<yaml::View> items = controller.list(key);
    if (std::any_of(items.begin(), items.end(),
                    [&](yaml::View item) { return item.text() == joint; })) {
      return true;
    }
  }
  return false;
}

bool has_unknown_joint(const LinkedModel& model, const RosController& controller) {
  const std::vector<yaml::View> joints = controller.list("joints");
  return std::any_of(joints.begin(), joints.end(),
                     [&](yaml::View joint) { return !model.joint_index(joint.text()); });
}

/// Whether the robot has none of the joints of a controller, which is then for another robot.
bool is_foreign(const std::vector<Reference>& references, const RosController& controller) {
  return std::none_of(references.begin(), references.end(), [&](const Reference& one) {
    return one.is_known() && one.kind == NameKind::joint &&
           is_in(one.span, controller.section.span());
  });
}

void check_reference_of(const LinkedModel& model, const RosController& controller,
                        const Reference& one, Findings& findings) {
  if (one.is_vague) {
    // `gains` and `constraints`: names of joints of the controller.
    if (controller.list("joints").empty() || lists(controller, one.name)) return;
    // Then it is `joints` that has another name than meant.
    if (model.joint_index(one.name) && has_unknown_joint(model, controller)) return;
    Diagnostic& found =
        findings.report(one.span, title_of(controller) + " has settings for the joint " +
                                      quoted(one.name) + ", which is not one of its joints");
    found.severity = Severity::warning;
    found.when(kSettings);
    std::vector<std::string_view> known;
    for (const yaml::View item : controller.list("joints")) known.push_back(item.text());
    if (const auto near = findings.suggest(one.name, known)) {
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
  if (found != nullptr && is_numbered) {
    found->severity = Severity::warning;
    found->when(kNumbered);
  }
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  const std::vector<Reference> references = companion_references(model, companions);
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& controller : file.controllers) {
      if (!controller.section || is_foreign(references, controller)) continue;
      for (const Reference& one : references) {
        if (one.kinds != NameKind::joint || is_placeholder(one.name)) continue;
        if (controller_at(file, one.span) != &controller) continue;
        check_reference_of(model, controller, one, findings);
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
    .facts = kFacts};

}  // namespace smurf::rules::sml3701_controller_unknown_joint_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3701_controller_unknown_joint =
    rules::sml3701_controller_unknown_joint_file::check;

}  // namespace smurf::companion_checks
