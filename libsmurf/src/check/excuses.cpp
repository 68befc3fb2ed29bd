// SPDX-License-Identifier: BSD-3-Clause
#include "check/excuses.hpp"

#include "base/findings/rules.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/ros2_control.hpp"
#include "lint/targets.hpp"
#include "smurf/xacro_cases.hpp"

namespace smurf {
namespace {

void excuse(Diagnostic& one) {
  one.severity = Severity::info;
  one.when(kExcused);
}

}  // namespace

void excuse_arguments(std::vector<Diagnostic>& found) {
  for (Diagnostic& one : found) {
    const bool is_open = one.rule == &rules::sml3313_xacro_unknown_argument ||
                         one.cases.contains(kNoPlugin) || one.cases.contains(kNoSimulation) ||
                         one.cases.contains(xacro::kEmptyFileName) ||
                         one.rule == &rules::sml3705_controller_interface;
    if (!is_open) continue;
    // There is no robot. So nobody knows what a target makes of it.
    if (one.rule->blocks_building) one.untargeted = one.severity;
    excuse(one);
  }
}

void excuse_one_of_several(std::vector<Diagnostic>& found) {
  for (Diagnostic& one : found) {
    const bool is_open =
        one.rule == &rules::sml3615_hardware_none || one.cases.contains(kNumberedJoint);
    if (is_open) excuse(one);
  }
}

bool is_part(const LinkedModel& model, const SourceMap& sources, bool was_found) {
  if (model.files.empty()) return false;
  const std::string_view text = sources.text(model.files.front().source);
  const std::size_t root = text.find("<robot");
  const std::string_view tag =
      root == std::string_view::npos ? "" : text.substr(root, text.find('>', root) - root);
  const bool has_name = tag.find("name=") != std::string_view::npos;
  if (model.robot) return model.robot->links.empty() && (was_found || !has_name);
  return was_found && !has_name;
}

}  // namespace smurf
