// SPDX-License-Identifier: BSD-3-Clause
#include "check/written_names.hpp"

#include <algorithm>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "link/companions/companion_names.hpp"
#include "plan/xacro_text.hpp"
#include "xacro/whole_word.hpp"

namespace smurf {
namespace {

/// What stands behind the last expression of a value: "elbow" of "${prefix}elbow".
std::string_view literal_end(std::string_view value) {
  std::size_t begin = value.size();
  while (begin > 0 && xacro::is_of_name(value[begin - 1])) --begin;
  const bool is_whole = begin == 0 || value[begin - 1] == '}' || value[begin - 1] == ')';
  return is_whole ? value.substr(begin) : std::string_view();
}

/// The names that a text writes, as far as they are no expressions.
struct Written {
  std::set<std::string_view> joints, links, values;
};

Written written_in(std::string_view text) {
  Written found;
  for (const XacroTag& tag : xacro_tags(text)) {
    const std::string_view element = tag.name.of(text);
    for (const XacroAttribute& one : tag.attributes) {
      const std::string_view value = literal_end(one.value.of(text));
      if (value.empty()) continue;
      found.values.insert(value);
      if (one.name.of(text) != "name") continue;
      if (element == "joint") found.joints.insert(value);
      if (element == "link") found.links.insert(value);
    }
  }
  return found;
}

}  // namespace

MisspeltNames find_misspelt(const std::string& companion, const SeenCompanion& seen,
                            const std::vector<std::string>& robots, CompanionRobots& texts) {
  constexpr std::size_t kMost = 2;  // names of one file that are misspelt
  MisspeltNames best;
  std::size_t most_known = 0;
  for (const std::string& robot : robots) {
    const Written written = written_in(texts.text_of(companion, robot));
    LinkedModel model;
    for (const std::string_view one : written.joints) model.joint_names.add(one, 0);
    for (const std::string_view one : written.links) model.link_names.add(one, 0);
    for (const CompanionName& one : seen.names) {
      // A macro may get the name.
      if (!written.values.contains(one.name)) continue;
      (one.kind == NameKind::link ? model.link_names : model.joint_names).add(one.name, 0);
    }
    const NameScore score = score_of(seen.names, model);
    // A package that is not here, such as that of a gripper, may write a few of the names.
    constexpr std::size_t kFewest = 4;
    const std::size_t sure = score.known + score.near.size();
    const bool is_nearly_whole = score.known >= kFewest && sure * 3 >= score.names * 2;
    if (sure < score.names && !is_nearly_whole) continue;
    if (score.known == 0 || score.known < most_known) continue;
    most_known = score.known;
    best = {};
    if (score.near.empty() || score.near.size() > kMost) continue;
    best.robot = robot;
    best.names = score.near;
    for (const auto* names : {&written.joints, &written.links}) {
      best.known.insert(best.known.end(), names->begin(), names->end());
    }
  }
  const bool is_known = std::any_of(best.names.begin(), best.names.end(), [&](const auto& one) {
    return texts.is_written(companion, one);
  });
  return is_known ? MisspeltNames{} : best;
}

void report_written(const Companion& companion, const MisspeltNames& misspelt,
                    DiagnosticSink& sink) {
  const Rule& rule = companion.kind == CompanionKind::controllers
                         ? rules::sml3701_controller_unknown_joint
                         : rules::sml3802_moveit_unknown_name;
  const std::vector<std::string_view> known(misspelt.known.begin(), misspelt.known.end());
  std::set<std::string_view> told;
  const LinkedModel nothing;
  for (const Reference& one : names_in_companion(nothing, companion)) {
    if (!misspelt.names.contains(one.name) || !told.insert(one.name).second) continue;
    const char* kind = one.kinds.contains(NameKind::link) ? "link " : "joint ";
    Diagnostic& found = sink.report(rule, one.span,
                                    "no file of the robot writes the " + std::string(kind) +
                                        quoted(one.name) + ", which is named here");
    found.severity = Severity::warning;
    found.note(quoted(misspelt.robot) +
               " could not be expanded here; this file was compared with its text");
    if (const auto near = nearest(one.name, known)) {
      found.help("did you mean " + quoted(*near) + "?");
      found.fixes.push_back({Applicability::unsafe, {{one.span, std::string(*near)}}});
    } else {
      found.help("correct the name, or give the robot what it needs");
    }
  }
}

}  // namespace smurf
