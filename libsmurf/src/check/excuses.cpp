// SPDX-License-Identifier: BSD-3-Clause
#include "check/excuses.hpp"

#include <map>
#include <string_view>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/ros2_control.hpp"
#include "verdict/targets.hpp"
#include "xacro/xacro_cases.hpp"

namespace smurf {
namespace {

void excuse(Diagnostic& one) {
  one.severity = Severity::info;
  one.when(kExcused);
}

}  // namespace

void excuse_arguments(std::vector<Diagnostic>& found) {
  for (Diagnostic& one : found) {
    const bool is_late = one.cases.contains(xacro::kLateDefault);
    const bool is_open = (one.rule == &rules::sml3313_xacro_unknown_argument && !is_late) ||
                         one.cases.contains(kNoPlugin) || one.cases.contains(kNoSimulation) ||
                         one.cases.contains(xacro::kEmptyFileName) ||
                         one.rule == &rules::sml3705_controller_interface;
    if (!is_open) continue;
    // There is no robot. So nobody knows what a target makes of it.
    if (one.rule->blocks_building) one.untargeted = one.severity;
    excuse(one);
  }
}

bool is_about_name(const Diagnostic& one) {
  return one.rule == &rules::sml3501_srdf_unknown_name ||
         one.rule == &rules::sml3701_controller_unknown_joint ||
         one.rule == &rules::sml3802_moveit_unknown_name;
}

void excuse_names(const Companions& companions, const SourceMap& sources, bool may_vary,
                  std::vector<Diagnostic>& found) {
  std::map<SourceId, const Companion*> files;
  for (const Companion& one : companions.files) files.emplace(one.source, &one);
  std::erase_if(found, [&](Diagnostic& one) {
    const auto file = files.find(one.span.source);
    const bool is_about_part = one.rule == &rules::sml3712_controller_unknown_part;
    if (file == files.end() || (!is_about_name(one) && !is_about_part)) return false;
    if (one.cases.contains(kLostPrefix)) return false;
    const Companion& companion = *file->second;
    if (is_about_part) {
      // Sensors of a robot that has few of the joints in the file are those of another one.
      const bool is_alien = companion.known_names * 2 < companion.names;
      if (is_alien && may_vary && !is_tie(companion.evidence)) excuse(one);
      return false;
    }
    const std::string_view name = sources.text(one.span);
    // An SRDF has one finding about all of them.
    const bool is_of_variant = companion.of_variants.contains(name);
    if (is_of_variant) return !companion.srdf;
    constexpr std::size_t kMostNear = 2;
    constexpr std::size_t kFew = 4;
    const bool is_misspelt =
        companion.near_names.contains(name) && companion.near_names.size() <= kMostNear;
    const bool is_for_it =
        companion.names >= kFew && companion.known_names * 10 >= companion.names * 9;
    const bool is_sure = is_misspelt || is_for_it || is_tie(companion.evidence) || !may_vary;
    if (!is_sure) excuse(one);
    if (!companion.stated_by.empty()) {
      one.note(quoted(companion.stated_by) + " gives this file to the robot");
    }
    return false;
  });
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
