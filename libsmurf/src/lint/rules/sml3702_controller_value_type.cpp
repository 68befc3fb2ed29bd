// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>
#include <string>

#include "lint/companions/controllers.hpp"

namespace smurf::rules::sml3702_controller_value_type_file {
namespace {

void report(yaml::View value, const std::string& subject, char wanted, Findings& findings) {
  const char got = rcl_type_of(value);
  Diagnostic& found =
      findings.report(value.span(), subject + " is " + (got == 'i' ? "an " : "a ") +
                                        std::string(parameter_type_name(got)) + ", but must be a " +
                                        std::string(parameter_type_name(wanted)));
  if (wanted == 'd' && got == 'i') {
    const std::string text(value.text());
    found.help("write " + quoted(text + ".0"));
    const bool is_decimal = text.find_first_not_of("+-0123456789") == std::string::npos;
    if (is_decimal) found.fixes.push_back({Applicability::safe, {{value.span(), text + ".0"}}});
  } else if (wanted == 's') {
    found.help("write it in quotes");
  } else {
    found.help("write a " + std::string(parameter_type_name(wanted)));
  }
}

void check_value(yaml::View value, const std::string& path, const RosParameter& parameter,
                 const RosController& controller, Findings& findings) {
  const bool is_list = std::isupper(static_cast<unsigned char>(parameter.type)) != 0;
  const std::string subject = quoted(path) + " of " + title_of(controller);
  if (value.is_scalar() && is_list) {
    if (rcl_type_of(value) == 0) return;
    findings.report(value.span(), subject + " must be a " + std::string(type_name(parameter)))
        .help("write `[" + std::string(value.text()) + "]`");
  } else if (value.is_sequence() && !is_list) {
    findings
        .report(value.span(),
                subject + " is a list, but must be a " + std::string(type_name(parameter)))
        .help("write one value");
  } else if (value.is_scalar()) {
    const char got = rcl_type_of(value);
    if (got != 0 && got != parameter.type) report(value, subject, parameter.type, findings);
  } else if (value.is_sequence()) {
    const char wanted = static_cast<char>(std::tolower(static_cast<unsigned char>(parameter.type)));
    for (const yaml::View item : value) {
      const char got = item.is_scalar() ? rcl_type_of(item) : '\0';
      if (got == 0 || got == wanted) continue;
      report(item, "a value in " + subject, wanted, findings);
      return;  // one finding per list
    }
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_known_controller(
      companions, [&](const RosController& controller, const std::vector<RosParameter>& known) {
        for_each_parameter(
            controller.section, known,
            [&](yaml::View value, const std::string& path, const RosParameter& parameter) {
              check_value(value, path, parameter, controller, findings);
            });
      });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks,
     "throws an exception when it loads the controller, and may end",
     "rclcpp parameter_value.cpp, node_parameters.cpp"},
};

}  // namespace

extern constinit const Rule sml3702_controller_value_type{
    .id = "SML3702",
    .name = "controller-value-type",
    .severity = Severity::error,
    .summary = "A parameter of a controller has a value of another type.",
    .why = "ROS 2 does not convert an integer to a double.",
    .remedy = "Write a value of the type of the parameter, such as `50.0` for a double.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3702_controller_value_type_file
