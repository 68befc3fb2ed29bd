// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3812_moveit_unknown_parameter_file {
namespace {

using Paths = std::vector<std::string_view>;  ///< the rest of each path below a mapping

std::string_view first_of(std::string_view path) { return path.substr(0, path.find('.')); }

/// The rests of the paths that begin with a key.
Paths below(const Paths& paths, std::string_view key) {
  Paths rest;
  for (const std::string_view one : paths) {
    if (first_of(one) != key || one.size() == key.size()) continue;
    rest.push_back(one.substr(key.size() + 1));
  }
  return rest;
}

/// The known name that begins with the key, if there is only one, such as `has_jerk_limits` for
/// `has_jerk`; otherwise a similar name.
std::optional<std::string_view> meant_by(std::string_view key, const Paths& names) {
  std::optional<std::string_view> longer;
  for (const std::string_view one : names) {
    const bool continues =
        one.size() > key.size() && one.starts_with(key) && one[key.size()] == '_';
    if (!continues || one == longer) continue;
    if (longer) return near_name(key, names);
    longer = one;
  }
  return longer ? longer : near_name(key, names);
}

// The recursion is as deep as the file, whose depth is limited.
void check_mapping(yaml::View mapping, const Paths& paths, bool is_top, Findings& findings) {
  Paths names;
  for (const std::string_view one : paths) {
    if (first_of(one) != "*") names.push_back(first_of(one));
  }
  const Paths any = below(paths, "*");
  for (const yaml::View member : mapping) {
    if (member.is_repeated()) continue;
    const std::string_view key = member.key();
    if (is_top && member.is_mapping() && is_moveit_wrapper(key)) {
      check_mapping(member, paths, true, findings);
    } else if (std::find(names.begin(), names.end(), key) != names.end()) {
      if (member.is_mapping()) check_mapping(member, below(paths, key), false, findings);
    } else if (member.is_mapping() && !any.empty()) {
      check_mapping(member, any, false, findings);
    } else if (const auto near = meant_by(key, names)) {
      Diagnostic& found =
          findings.report(member.key_span(), "MoveIt has no parameter " + quoted(key) + " here");
      found.help("did you mean " + quoted(*near) + "?");
      if (mapping.find(*near)) continue;
      found.fixes.push_back({Applicability::unsafe, {{member.key_span(), std::string(*near)}}});
    }
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for (const Companion& file : companions.files) {
    const MoveitFile* kind = find_moveit_file(spec_of(file.kind).title);
    if (kind == nullptr || !file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    Paths paths;
    for (const RosParameter& one : parameters_of(*kind)) paths.push_back(one.path);
    check_mapping(root, paths, true, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::loses, "ignores it without a message",
     "moveit2 robot_model_loader.cpp, moveit_simple_controller_manager.cpp, ompl_interface.cpp"},
};

}  // namespace

extern constinit const Rule sml3812_moveit_unknown_parameter{
    .id = "SML3812",
    .name = "moveit-unknown-parameter",
    .severity = Severity::warning,
    .summary = "A parameter of MoveIt is misspelt.",
    .remedy = "Correct the name.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3812_moveit_unknown_parameter_file
