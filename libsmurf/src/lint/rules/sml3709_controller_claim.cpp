// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>

#include "base/text/counted.hpp"
#include "lint/companions/controllers.hpp"

namespace smurf::rules::sml3709_controller_claim_file {
namespace {

using Claims = std::map<std::string, const RosController*>;

/// Reports the first interface that a controller claims after another one.
void check_controller(const RosController& controller, Claims& claims, Diagnostic*& found,
                      std::size_t& count, Findings& findings) {
  const std::string_view key =
      controller.list("command_joints").empty() ? "joints" : "command_joints";
  bool is_counted = false;
  for (const yaml::View joint : controller.list(key)) {
    for (const yaml::View interface : controller.list("command_interfaces")) {
      const std::string claim = std::string(joint.text()) + "/" + std::string(interface.text());
      const auto [first, is_new] = claims.emplace(claim, &controller);
      if (is_new || is_counted || first->second == &controller || is_placeholder(claim)) continue;
      is_counted = true;
      ++count;
      if (found != nullptr) continue;
      found = &findings.report(controller.place, title_of(controller) + " and " +
                                                     quoted(first->second->name) +
                                                     " both command " + quoted(claim));
      found->label(first->second->place, "the other one");
      found->help("activate only one of them at a time");
    }
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    Claims claims;
    Diagnostic* found = nullptr;
    std::size_t count = 0;
    for (const RosController& one : file.controllers) {
      if (one.section) check_controller(one, claims, found, count, findings);
    }
    if (count > 1) {
      found->note(counted(count - 1, "more controller") + " of this file claim what others claim");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::changes,
     "does not activate the second of them while the first is active",
     "ros2_control hardware_interface/src/resource_manager.cpp claim_command_interface"},
};

}  // namespace

extern constinit const Rule sml3709_controller_claim{
    .id = "SML3709",
    .name = "controller-claim",
    .severity = Severity::info,
    .summary = "Two controllers of a file command the same interface.",
    .remedy = "Activate only one of them at a time.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3709_controller_claim_file
