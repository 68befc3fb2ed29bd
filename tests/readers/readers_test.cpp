// SPDX-License-Identifier: BSD-3-Clause
// The table of readers, and what targets do to findings.
#include "smurf/readers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "support/loaded.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

Diagnostic at(std::string_view rule, std::string pointer, std::string construct = {}) {
  Diagnostic diagnostic;
  diagnostic.rule = find_rule(rule);
  diagnostic.severity = diagnostic.rule->severity;
  diagnostic.pointer = std::move(pointer);
  diagnostic.construct = std::move(construct);
  return diagnostic;
}

Effect effect_of(std::string_view reader, const Diagnostic& diagnostic) {
  const ReaderFact* fact = find_fact(*find_target(reader), diagnostic);
  return fact == nullptr ? Effect::takes : fact->effect;
}

/// Severity of the only finding for these targets.
Severity severity_for(const Diagnostic& diagnostic, std::vector<std::string_view> targets) {
  RuleSelection selection;
  for (const std::string_view name : targets) selection.targets.push_back(find_target(name));
  SourceMap sources;
  Diagnostic placed = diagnostic;
  placed.span.source = sources.add("robot.urdf", "");
  const std::vector<Diagnostic> finished = finish({placed}, sources, selection);
  REQUIRE(finished.size() == 1);
  return finished[0].severity;
}

}  // namespace

TEST_CASE("every fact is about a rule, says something, and can be reached") {
  std::set<std::string_view> names;
  for (const Reader* reader : all_readers()) {
    CAPTURE(reader->name);
    CHECK(names.insert(reader->name).second);
    CHECK(!reader->title.empty());
    CHECK(!reader->basis.empty());
    CHECK(!reader->facts.empty());
    for (std::size_t i = 0; i < reader->facts.size(); ++i) {
      const ReaderFact& fact = reader->facts[i];
      CAPTURE(fact.rule);
      CAPTURE(fact.where);
      CHECK(std::any_of(all_rules().begin(), all_rules().end(),
                        [&](const Rule* rule) { return rule->id.starts_with(fact.rule); }));
      CHECK(!fact.source.empty());
      CHECK(!fact.makes.empty());
      CHECK(!fact.makes.ends_with('.'));
      for (std::size_t k = 0; k < i; ++k) {
        const ReaderFact& before = reader->facts[k];
        const bool hides = fact.rule.starts_with(before.rule) &&
                           fact.where.find(before.where) != std::string_view::npos;
        CHECK_MESSAGE(!hides, "row " << k << " hides it");
      }
    }
  }
}

TEST_CASE("targets are known by name") {
  CHECK(find_target("mujoco")->title == "MuJoCo");
  CHECK(find_target("urdfdom") == nullptr);
  CHECK(find_target("MuJoCo") == nullptr);
  const std::vector<std::string_view> names = target_names();
  for (const char* name :
       {"mars", "mars2", "phobos", "pybullet", "ros", "gazebo", "dart", "mujoco", "drake"}) {
    CHECK(std::find(names.begin(), names.end(), name) != names.end());
  }
}

TEST_CASE("facts see the path without names and indices") {
  CHECK(fact_path(at("SML1802", "/robot/link[@name='a/[b]']/inertial/mass/@value")) ==
        "/robot/link/inertial/mass/@value/");
  CHECK(fact_path(at("SML4101", "/motors/12/type", "DC")) == "/motors/type/#DC");
  CHECK(fact_path(at("SML1115", "")) == "/");
}

TEST_CASE("the first fact that fits wins, then those of what a reader is built on") {
  const Diagnostic in_link = at("SML1801", "/robot/link[@name='a']/inertial/mass/@value");
  const Diagnostic in_joint = at("SML1801", "/robot/joint[@name='j']/limit/@effort");
  CHECK(effect_of("ros", in_link) == Effect::breaks);
  CHECK(effect_of("ros", in_joint) == Effect::refuses);
  CHECK(effect_of("dart", in_joint) == Effect::refuses);
  CHECK(effect_of("pybullet", in_joint) == Effect::changes);
  CHECK(effect_of("gazebo", at("SML1206", "/robot")) == Effect::breaks);
  CHECK(effect_of("ros", at("SML1206", "/robot")) == Effect::changes);
  CHECK(effect_of("mujoco", at("SML1115", "/robot")) == Effect::takes);
  CHECK(effect_of("ros", at("SML1115", "/robot")) == Effect::refuses);
}

TEST_CASE("the severity is that of the worst target") {
  const Diagnostic bounds_equal = at("SML1408", "/robot/joint/limit/@upper");
  CHECK(severity_for(bounds_equal, {}) == Severity::warning);
  CHECK(severity_for(bounds_equal, {"mujoco"}) == Severity::warning);
  CHECK(severity_for(bounds_equal, {"ros"}) == Severity::info);
  const Diagnostic effort_missing = at("SML1404", "/robot/joint/limit");
  CHECK(severity_for(effort_missing, {"ros"}) == Severity::error);
  CHECK(severity_for(effort_missing, {"pybullet"}) == Severity::warning);
  CHECK(severity_for(effort_missing, {"pybullet", "ros"}) == Severity::error);
  CHECK(severity_for(effort_missing, {"mujoco"}) == Severity::warning);  // takes it: one milder
  CHECK(severity_for(at("SML1407", "/robot/joint/limit"), {"drake"}) == Severity::error);
  CHECK(severity_for(at("SML1407", "/robot/joint/limit"), {"mars"}) == Severity::info);
}

TEST_CASE("what no body can be stays an error, and what nobody knows stays as it is") {
  CHECK(severity_for(at("SML1513", "/robot/link/inertial"), {"pybullet"}) == Severity::error);
  CHECK(severity_for(at("SML1411", "/robot/joint/limit"), {"ros"}) == Severity::warning);
  CHECK(!has_facts(*find_rule("SML1411")));
}

TEST_CASE("--severity has the last word") {
  RuleSelection selection;
  selection.targets = {find_target("ros")};
  selection.severities["SML1404"] = Severity::info;
  SourceMap sources;
  Diagnostic finding = at("SML1404", "/robot/joint/limit");
  finding.span.source = sources.add("robot.urdf", "");
  CHECK(finish({finding}, sources, selection)[0].severity == Severity::info);
}

TEST_CASE("notes say what the targets make of it, equal ones once") {
  RuleSelection selection;
  selection.targets = {find_target("ros"), find_target("dart"), find_target("pybullet")};
  SourceMap sources;
  Diagnostic finding = at("SML1404", "/robot/joint/limit");
  finding.span.source = sources.add("robot.urdf", "");
  CHECK(finish({finding}, sources, selection)[0].notes ==
        std::vector<std::string>{"ros, dart: refuses the file",
                                 "pybullet: reads 0: the joint has no force"});
}

TEST_CASE("verdicts count refusals and losses, and name the first") {
  const std::vector<Diagnostic> findings = {at("SML1408", "/robot/joint/limit/@upper"),
                                            at("SML1409", "/robot/joint/limit"),
                                            at("SML1404", "/robot/joint/limit")};
  const TargetVerdict mujoco = judge_target(*find_target("mujoco"), findings);
  CHECK(mujoco.refusals == 0);
  CHECK(mujoco.losses == 2);
  CHECK(mujoco.first == &findings[0]);
  CHECK(to_word(mujoco) == "loses");
  const TargetVerdict ros = judge_target(*find_target("ros"), findings);
  CHECK(ros.refusals == 1);
  CHECK(ros.first == &findings[2]);
  CHECK(to_word(ros) == "refuses");
  const TargetVerdict drake = judge_target(*find_target("drake"), {});
  CHECK(to_word(drake) == "takes");
  CHECK(drake.first == nullptr);
}
