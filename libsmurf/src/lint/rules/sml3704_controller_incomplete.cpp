// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "base/findings/uncertain.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml3704_controller_incomplete_file {
namespace {

constexpr Circumstance kType{"type"};
constexpr Circumstance kSection{"section"};

/// Whether a launch file gives the type: `spawner NAME --controller-type TYPE`.
bool gets_type(std::string_view name, const Companions& companions) {
  bool is_given = false;
  for_each_launch(companions, [&](const LaunchFile& launch) {
    for (const LaunchNode& node : launch.nodes) {
      bool has_name = false, has_type = false;
      for (const LaunchText& one : node.arguments) {
        has_name = has_name || one.text == name;
        has_type = has_type || is_one_of(one.text, {"-t", "--controller-type"});
      }
      is_given = is_given || (has_name && has_type);
    }
  });
  return is_given;
}

void check_type(const RosController& controller, const Companions& companions, Findings& findings) {
  if (!controller.type) {
    if (!controller.section) return;  // a setting of controller_manager
    if (gets_type(controller.name, companions)) return;
    Diagnostic& found =
        findings.report(controller.place, title_of(controller) + " has no `type`").when(kType);
    const yaml::View inner = controller.declared.is_mapping()
                                 ? controller.declared.find("ros__parameters")
                                 : yaml::View();
    if (inner && inner.is_mapping() && inner.find("type")) {
      found.help("delete this `ros__parameters`: `type` belongs directly below the controller");
      found.label(inner.find("type").key_span(), "here it is a parameter of another name");
    } else {
      found.help("write `type: PACKAGE/CLASS`");
    }
    return;
  }
  if (controller.known != nullptr || !controller.type.is_scalar()) return;
  std::vector<std::string_view> known;
  for (const ControllerClass& one : controller_classes()) known.push_back(one.name);
  const std::string_view type = trimmed(controller.type.text());
  std::string_view own;  // a class that the package exports, if it is around the robot
  for (const ExportedClass& one : companions.classes) {
    if (!one.base.starts_with("controller_interface::")) continue;
    if (one.name == type) return;
    if (one.package == type.substr(0, type.find('/'))) own = one.name;
    known.push_back(one.name);
  }
  const auto near = only_nearest(type, known);
  // Other packages have controllers of similar names.
  const auto package = [](std::string_view one) { return one.substr(0, one.find('/')); };
  const bool is_own = std::any_of(known.begin(), known.end(), [&](std::string_view one) {
    return package(one) == package(type);
  });
  constexpr int kMostEdits = 2;  // in the name of a package
  const bool is_slip =
      near && edit_distance(package(*near), package(type), kMostEdits) <= kMostEdits;
  const bool is_misspelt = near && (is_own || is_slip);
  if (is_placeholder(type) || (!is_misspelt && own.empty())) return;
  Diagnostic& found = findings.report(
      controller.type.span(), title_of(controller) + " has the unknown type " + quoted(type));
  found.when(kType);
  if (!is_misspelt) {
    found.severity = Severity::warning;
    found.help("write a class that the package exports, such as " + quoted(own));
    return;
  }
  found.help("did you mean " + quoted(*near) + "?");
  found.fixes.push_back({Applicability::unsafe, {{controller.type.span(), std::string(*near)}}});
}

bool is_set(const RosController& controller, std::string_view path) {
  yaml::View value = controller.section;
  while (true) {
    const std::size_t dot = path.find('.');
    value = value.find(path.substr(0, dot));
    if (!value) return false;
    if (dot == std::string_view::npos) break;
    path.remove_prefix(dot + 1);
    if (!value.is_mapping()) return false;
  }
  if (value.is_sequence()) return value.size() > 0;
  return value.is_scalar() && !value.text().empty();
}

/// Parameters may also be in other files; a section shows that they are here.
void check_required(const RosController& controller, Findings& findings) {
  if (controller.known == nullptr || !controller.section) return;
  const std::vector<RosParameter> all = parameters_of(*controller.known);
  // A parameter that no distribution knows may be one of another version, which needs others.
  for (const yaml::View member : controller.section) {
    const std::string_view key = member.key();
    const bool is_known = std::any_of(all.begin(), all.end(), [&](const RosParameter& one) {
      return one.path.substr(0, one.path.find('.')) == key || one.path == key;
    });
    if (!is_known && key.find('.') == std::string_view::npos) return;
  }
  std::string missing;
  for (const RosParameter& one : all) {
    const bool is_by_name = one.path.find('*') != std::string_view::npos;
    const bool is_everywhere = one.distributions == controller.known->distributions;
    if (!one.is_required || is_by_name || !is_everywhere) continue;
    if (is_set(controller, one.path)) continue;
    // The part above may be written with dots.
    if (one.path.find('.') != std::string_view::npos && controller.section.find(one.path)) continue;
    missing += (missing.empty() ? "" : ", ") + quoted(one.path);
  }
  if (missing.empty()) return;
  findings.report(controller.place, title_of(controller) + " does not set " + missing)
      .help("write a value for it below `ros__parameters` of the controller");
}

/// A controller that needs parameters, but has none in any file. Launch files can give others.
void check_section(const RosController& controller, const std::set<std::string_view>& sections,
                   Findings& findings) {
  if (controller.known == nullptr || controller.section || sections.contains(controller.name))
    return;
  if (controller.declared.find("params_file") || is_placeholder(controller.name)) return;
  const std::vector<RosParameter> all = parameters_of(*controller.known);
  const bool needs_some = std::any_of(all.begin(), all.end(), [](const RosParameter& one) {
    return one.is_required && one.path.find('*') == std::string_view::npos;
  });
  if (!needs_some) return;
  Diagnostic& found = findings.report(
      controller.place, title_of(controller) + " has a type, but no section with parameters");
  found.severity = Severity::info;
  found.when(kSection).when(kUncertain);
  const bool is_misplaced = std::any_of(all.begin(), all.end(), [&](const RosParameter& one) {
    return one.is_required && controller.declared.find(one.path);
  });
  if (is_misplaced) {
    found.severity = Severity::warning;
    found.message = title_of(controller) + " has no section: its parameters stand in the one of "
                                           "`controller_manager`";
    found.help("move them into a section " + quoted(controller.name) + " at the left margin");
    return;
  }
  found.help("write `" + std::string(controller.name) + ": ros__parameters: ...`");
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  std::set<std::string_view> sections;
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) {
      if (one.section) sections.insert(one.name);
    }
  });
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& controller : file.controllers) {
      check_type(controller, companions, findings);
      check_required(controller, findings);
      check_section(controller, sections, findings);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks,
     "does not configure the controller, unless a launch file passes its parameters",
     "ros2_controllers *_parameters.yaml", when(kSection, kUncertain)},
    {&readers::ros2_control, Effect::breaks, "reports an error and does not load the controller",
     "ros2_control controller_manager.cpp load_controller", when(kType)},
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not configure the controller",
     "ros2_controllers *_parameters.yaml"},
};

}  // namespace

extern constinit const Rule sml3704_controller_incomplete{
    .id = "SML3704",
    .name = "controller-incomplete",
    .severity = Severity::error,
    .summary = "A controller has no type, or lacks a parameter that it needs.",
    .remedy = "Write the type or the parameter.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3704_controller_incomplete_file
