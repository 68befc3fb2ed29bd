// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/controllers.hpp"

namespace smurf::rules::sml3707_controller_update_rate_file {
namespace {

constexpr Circumstance kManager{"manager"};

void check_rate(const RosController& controller, yaml::View rate, std::int64_t manager,
                Findings& findings) {
  const auto own = rate.is_scalar() ? rate.integer() : std::nullopt;
  if (!own || *own <= 0) return;
  if (*own > manager) {
    findings
        .report(rate.span(), title_of(controller) + " wants " + std::to_string(*own) +
                                 " Hz, more than the " + std::to_string(manager) +
                                 " Hz of controller_manager")
        .help("write at most " + std::to_string(manager));
  } else if (manager % *own != 0) {
    findings
        .report(rate.span(), title_of(controller) + " wants " + std::to_string(*own) +
                                 " Hz, which does not divide the " + std::to_string(manager) +
                                 " Hz of controller_manager")
        .help("write a divisor of " + std::to_string(manager));
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    const yaml::View rate = file.manager ? file.manager.find("update_rate") : yaml::View();
    if (!rate || !rate.is_scalar() || is_placeholder(rate.text())) return;
    const auto manager = rate.integer();
    if (!manager || *manager <= 0) {
      Diagnostic& found = findings.report(rate.span(), "`update_rate` of controller_manager is " +
                                                           quoted(rate.text()));
      found.severity = Severity::error;
      found.when(kManager);
      found.help("write a positive whole number, without a point");
      return;
    }
    for (const RosController& one : file.controllers) {
      if (const yaml::View own = one.parameter("update_rate")) {
        check_rate(one, own, *manager, findings);
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::refuses, "throws an exception and ends",
     "ros2_control controller_manager.cpp", when(kManager)},
    {&readers::ros2_control, Effect::changes, "warns and updates the controller at another rate",
     "ros2_control controller_manager.cpp:1668-1687"},
};

}  // namespace

extern constinit const Rule sml3707_controller_update_rate{
    .id = "SML3707",
    .name = "controller-update-rate",
    .severity = Severity::warning,
    .summary = "An update rate is not a positive whole number, or does not fit the manager's rate.",
    .remedy = "Write a positive whole number, for a controller a divisor of the manager's rate.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3707_controller_update_rate_file
