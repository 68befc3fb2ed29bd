// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/text/suggest.hpp"
#include "lint/companions/controllers.hpp"

namespace smurf::rules::sml3703_controller_unknown_parameter_file {
namespace {

/// The names that may be at one level: the parts of known paths behind a prefix.
std::vector<std::string_view> names_behind(const std::vector<RosParameter>& known,
                                           std::string_view prefix) {
  std::vector<std::string_view> names;
  for (const RosParameter& one : known) {
    if (!one.path.starts_with(prefix)) continue;
    const std::string_view rest = one.path.substr(prefix.size());
    const std::string_view name = rest.substr(0, rest.find('.'));
    if (name != "*") names.push_back(name);
  }
  return names;
}

void check_mapping(yaml::View mapping, const std::string& prefix,
                   const std::vector<RosParameter>& known, const RosController& controller,
                   Findings& findings) {
  const std::vector<std::string_view> names = names_behind(known, prefix);
  if (names.empty()) return;
  for (const yaml::View member : mapping) {
    if (member.is_repeated()) continue;
    const bool is_known = std::find(names.begin(), names.end(), member.key()) != names.end();
    if (is_known) {
      if (member.is_mapping()) {
        check_mapping(member, prefix + std::string(member.key()) + ".", known, controller,
                      findings);
      }
      continue;
    }
    if (member.is_mapping()) continue;  // by the name of a joint
    const auto near = only_nearest(member.key(), names);
    if (!near) continue;
    Diagnostic& found =
        findings.report(member.key_span(), title_of(controller) + " has no parameter " +
                                               quoted(prefix + std::string(member.key())));
    const std::string group = prefix + std::string(*near) + ".";
    const bool is_group = std::any_of(known.begin(), known.end(), [&](const RosParameter& one) {
      return one.path.starts_with(group);
    });
    found.help("did you mean " + quoted(*near) + (is_group ? ", which is a mapping?" : "?"));
    if (is_group || mapping.find(*near)) continue;
    found.fixes.push_back({Applicability::unsafe, {{member.key_span(), std::string(*near)}}});
  }
}

/// The parameters of controller_manager itself; its other members are controllers.
void check_manager(yaml::View manager, Findings& findings) {
  const std::vector<RosParameter> known = manager_parameters();
  const std::vector<std::string_view> names = names_behind(known, "");
  for (const yaml::View member : manager) {
    if (member.is_repeated() || member.is_mapping()) continue;
    const auto near = near_name(member.key(), names);
    if (!near) continue;
    Diagnostic& found = findings.report(member.key_span(), "controller_manager has no parameter " +
                                                               quoted(member.key()));
    found.help("did you mean " + quoted(*near) + "?");
    if (manager.find(*near)) continue;
    found.fixes.push_back({Applicability::unsafe, {{member.key_span(), std::string(*near)}}});
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_known_controller(
      companions, [&](const RosController& controller, const std::vector<RosParameter>& known) {
        check_mapping(controller.section, "", known, controller, findings);
      });
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    if (file.manager) check_manager(file.manager, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::loses, "ignores it without a message",
     "rclcpp node_parameters.cpp"},
};

}  // namespace

extern constinit const Rule sml3703_controller_unknown_parameter{
    .id = "SML3703",
    .name = "controller-unknown-parameter",
    .severity = Severity::warning,
    .summary = "A parameter of a controller, or of controller_manager, is misspelt.",
    .why = "The program uses its default for the parameter that was meant.",
    .remedy = "Correct the name.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3703_controller_unknown_parameter_file
