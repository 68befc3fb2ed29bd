// SPDX-License-Identifier: BSD-3-Clause
// What a rule is about, and findings at several places: the worst place decides.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/findings/place_names.hpp"
#include "smurf/verdict.hpp"
#include "support/loaded.hpp"
#include "verdict/join.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

Diagnostic finding_of(const Rule& rule, SourceId file) {
  Diagnostic finding;
  finding.rule = &rule;
  finding.severity = rule.severity;
  finding.span.source = file;
  finding.pointer = "/robot";
  return finding;
}

bool is_of_lint(const Rule& rule) {
  return rule.reported_by == Tool::lint && !rule.id.starts_with("SML9");
}

/// All targets, and each of their releases.
std::vector<const Reader*> targets() {
  std::vector<const Reader*> all;
  for (const std::string_view name : target_names()) all.push_back(find_target(name));
  return all;
}

constexpr std::string_view kInertial =
    R"(<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>)";

TargetVerdict verdict_on(const std::string& urdf, std::string_view target) {
  Loaded loaded;
  loaded.files.add("robot.urdf", urdf);
  loaded.load("robot.urdf");
  return judge_target(*find_target(target), loaded.diagnostics);
}

}  // namespace

TEST_CASE("no target makes a finding milder that is about the robot") {
  std::size_t rules = 0;
  for (const Rule* rule : all_rules()) {
    if (rule->about != About::robot) continue;
    ++rules;
    CHECK(!rule->needs_target);
    for (const Reader* target : targets()) {
      CAPTURE(rule->id);
      CAPTURE(target->name);
      RuleSelection selection;
      selection.targets = {target};
      SourceMap sources;
      const SourceId file = sources.add("robot.urdf", "");
      const auto kept = apply_selection({finding_of(*rule, file)}, sources, selection);
      REQUIRE(kept.size() == 1);
      CHECK(kept[0].severity >= rule->severity);
    }
  }
  CHECK(rules > 60);
}

TEST_CASE("without a fact, an error is not known, and a warning keeps no reader from loading") {
  std::size_t errors = 0, others = 0;
  for (const Rule* rule : all_rules()) {
    if (rule->needs_target || !is_of_lint(*rule)) continue;
    for (const Reader* target : targets()) {
      const Diagnostic finding = finding_of(*rule, {});
      if (find_fact(*target, finding) != nullptr) continue;
      CAPTURE(rule->id);
      CAPTURE(target->name);
      const bool is_error = rule->severity == Severity::error;
      ++(is_error ? errors : others);
      CHECK(judge_target(*target, std::vector{finding}).answer() ==
            (is_error ? Answer::unknown : Answer::takes));
    }
  }
  CHECK(errors > 100);
  CHECK(others > 100);
}

TEST_CASE("a visual in front does not hide what a reader makes of the collision behind it") {
  const std::string mesh = R"(<geometry><mesh filename="http://x/a.stl"/></geometry>)";
  const std::string visual = "<visual>" + mesh + "</visual>";
  const std::string collision = "<collision>" + mesh + "</collision>";
  for (const std::string& shapes : {visual + collision, collision + visual}) {
    const std::string robot =
        "<robot name='r'><link name='a'>" + std::string(kInertial) + shapes + "</link></robot>";
    CAPTURE(shapes);
    CHECK(verdict_on(robot, "mujoco").answer() == Answer::refuses);
    CHECK(verdict_on(robot, "mars").answer() == Answer::refuses);
  }
}

TEST_CASE("a habit is one finding, and each of its places counts") {
  const auto joint = [](const std::string& name) {
    return "<link name='l" + name + "'>" + std::string(kInertial) + "</link><joint name='j" + name +
           "' type='continuous'><parent link='a'/><child link='l" + name +
           "'/><axis xyz='0 0 1'/><limit effort='0' velocity='1'/></joint>";
  };
  const std::string robot = "<robot name='r'><link name='a'>" + std::string(kInertial) + "</link>" +
                            joint("1") + joint("2") + joint("3") + "</robot>";
  Loaded loaded;
  loaded.files.add("robot.urdf", robot);
  loaded.load("robot.urdf");
  std::size_t shown = 0;
  for (const Diagnostic& one : loaded.diagnostics) {
    if (one.rule->id != "SML1414") continue;
    ++shown;
    CHECK(one.notes.back() == "2 more such limits in this file");
  }
  CHECK(shown == 1);
  CHECK(judge_target(*find_target("gazebo"), loaded.diagnostics).losses == 3);
}

TEST_CASE("the most severe place of a cause speaks, and equal places are counted") {
  SourceMap sources;
  const SourceId file = sources.add("robot.urdf", "");
  const auto place = [&](std::uint32_t at, Severity severity) {
    Diagnostic finding = finding_of(*find_rule("SML1414"), file);
    finding.span = {file, at, at + 1};
    finding.severity = severity;
    finding.message = std::to_string(at);
    finding.others_are = "such places";
    return finding;
  };
  std::vector<Diagnostic> found = {place(1, Severity::info), place(2, Severity::error),
                                   place(3, Severity::info), place(4, Severity::error)};
  join_places(found, sources);
  REQUIRE(found.size() == 1);
  CHECK(found[0].message == "2");
  CHECK(found[0].severity == Severity::error);
  REQUIRE(found[0].others.size() == 1);
  CHECK(found[0].others[0].count == 3);
  CHECK(found[0].notes == std::vector<std::string>{"3 more such places in this file"});
}
