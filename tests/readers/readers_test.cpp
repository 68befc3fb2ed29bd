// SPDX-License-Identifier: BSD-3-Clause
// The table of readers, and the effect of targets on findings.
#include "smurf/readers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "smurf/check.hpp"
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

void check_text(const Fact& fact) {
  CAPTURE(fact.makes);
  REQUIRE(fact.reader != nullptr);
  CHECK(!fact.makes.empty());
  CHECK(!fact.makes.ends_with('.'));
  CHECK(!fact.evidence.empty());
  CHECK((fact.evidence != kRun || !fact.reader->version.empty()));
}

Effect effect_of(std::string_view reader, const Diagnostic& diagnostic) {
  const Fact* fact = find_fact(*find_target(reader), diagnostic);
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

TEST_CASE("readers say who they are") {
  std::set<std::string_view> names;
  for (const Reader* reader : all_readers()) {
    CAPTURE(reader->name);
    CHECK(names.insert(reader->name).second);
    CHECK(!reader->title.empty());
    CHECK(!reader->basis.empty());
    for (const FamilyFact& one : reader->families) {
      const std::string_view family = one.family;
      const Fact& fact = one.fact;
      CAPTURE(family);
      check_text(fact);
      CHECK(fact.reader == reader);
      CHECK(std::any_of(all_rules().begin(), all_rules().end(),
                        [&](const Rule* rule) { return rule->id.starts_with(family); }));
    }
    for (const Fact& fact : reader->unread) {
      check_text(fact);
      CHECK(fact.reader == reader);
      CHECK(!fact.where.empty());
      CHECK(fact.effect == Effect::ignores);
    }
  }
}

TEST_CASE("every fact says something, and can be reached") {
  for (const Rule* rule : all_rules()) {
    CAPTURE(rule->id);
    for (std::size_t i = 0; i < rule->facts.size(); ++i) {
      const Fact& fact = rule->facts[i];
      CAPTURE(fact.where);
      check_text(fact);
      for (std::size_t k = 0; k < i; ++k) {
        const Fact& before = rule->facts[k];
        const bool hides =
            fact.reader == before.reader && fact.where.find(before.where) != std::string_view::npos;
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
  CHECK(effect_of("gazebo", at("SML1206", "/robot")) == Effect::refuses);
  CHECK(effect_of("ros", at("SML1206", "/robot")) == Effect::changes);
  CHECK(effect_of("mujoco", at("SML1115", "/robot")) == Effect::takes);
  CHECK(effect_of("ros", at("SML1115", "/robot")) == Effect::refuses);
}

TEST_CASE("what a reader does not look at it takes, unless it cannot read the file") {
  const std::string size = "/robot/link[@name='a']/visual/geometry/box/@size";
  CHECK(effect_of("mujoco", at("SML1801", size)) == Effect::ignores);
  CHECK(effect_of("mujoco", at("SML1007", size)) == Effect::refuses);
  CHECK(effect_of("mujoco", at("SML1801", size, "#visuals-kept")) == Effect::refuses);
  CHECK(effect_of("ros", at("SML1801", size)) == Effect::breaks);
}

TEST_CASE("the severity is that of the worst target") {
  const Diagnostic bounds_equal = at("SML1408", "/robot/joint/limit/@upper");
  CHECK(severity_for(bounds_equal, {}) == Severity::warning);
  CHECK(severity_for(bounds_equal, {"mujoco"}) == Severity::warning);
  CHECK(severity_for(bounds_equal, {"ros"}) == Severity::info);
  const Diagnostic effort_missing = at("SML1404", "/robot/joint/limit", "effort");
  CHECK(severity_for(effort_missing, {"ros"}) == Severity::error);
  CHECK(severity_for(effort_missing, {"pybullet"}) == Severity::warning);
  CHECK(severity_for(effort_missing, {"pybullet", "ros"}) == Severity::error);
  CHECK(severity_for(effort_missing, {"mujoco"}) == Severity::warning);  // takes: one level milder
  const Diagnostic too_large = at("SML0002", "/robot");
  CHECK(severity_for(too_large, {"mujoco"}) == Severity::error);  // the target may refuse it
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
  Diagnostic finding = at("SML1404", "/robot/joint/limit", "effort");
  finding.span.source = sources.add("robot.urdf", "");
  CHECK(finish({finding}, sources, selection)[0].severity == Severity::info);
}

TEST_CASE("notes say what the targets make of it, equal ones once") {
  RuleSelection selection;
  selection.targets = {find_target("ros"), find_target("dart"), find_target("pybullet")};
  SourceMap sources;
  Diagnostic finding = at("SML1404", "/robot/joint/limit", "effort");
  finding.span.source = sources.add("robot.urdf", "");
  CHECK(finish({finding}, sources, selection)[0].notes ==
        std::vector<std::string>{"ros, dart: refuses the file",
                                 "pybullet: reads 0: the joint has no force"});
}

TEST_CASE("verdicts count refusals and losses, and name the worst") {
  const std::vector<Diagnostic> findings = {at("SML1408", "/robot/joint/limit/@upper"),
                                            at("SML1409", "/robot/joint/limit"),
                                            at("SML1403", "/robot/joint")};
  const TargetVerdict mujoco = judge_target(*find_target("mujoco"), findings);
  CHECK(mujoco.refusals == 0);
  CHECK(mujoco.losses == 3);
  CHECK(mujoco.rule->id == "SML1408");
  CHECK(mujoco.answer() == Answer::loses);
  const TargetVerdict ros = judge_target(*find_target("ros"), findings);
  CHECK(ros.refusals == 1);
  CHECK(ros.rule->id == "SML1403");
  CHECK(ros.answer() == Answer::refuses);
  const TargetVerdict drake = judge_target(*find_target("drake"), {});
  CHECK(drake.answer() == Answer::takes);
  CHECK(drake.rule == nullptr);
}

TEST_CASE("an error of which nothing is known is no reason to say that a reader takes it") {
  Diagnostic unknown = at("SML0002", "/robot");
  REQUIRE(unknown.severity == Severity::error);
  REQUIRE(find_fact(*find_target("ros"), unknown) == nullptr);
  const TargetVerdict verdict = judge_target(*find_target("ros"), std::vector{unknown, unknown});
  CHECK(verdict.answer() == Answer::unknown);
  CHECK(verdict.unknown == 2);
  CHECK(verdict.unknown_rules == std::vector<const Rule*>{unknown.rule});
  const std::vector<Diagnostic> worse = {unknown, at("SML1403", "/robot/joint")};
  CHECK(judge_target(*find_target("ros"), worse).answer() == Answer::refuses);
  const std::vector<Diagnostic> milder = {unknown, at("SML1406", "/robot/joint/limit")};
  CHECK(judge_target(*find_target("ros"), milder).answer() == Answer::unknown);
  unknown.severity = Severity::warning;
  CHECK(judge_target(*find_target("ros"), std::vector{unknown}).answer() == Answer::takes);
}

TEST_CASE("a refusal that depends on files outside of the model is not known") {
  const Diagnostic include = at("SML1447", "/robot/gazebo/include/uri", "uncertain");
  CHECK(severity_for(include, {"gazebo"}) == Severity::warning);
  const TargetVerdict verdict = judge_target(*find_target("gazebo"), std::vector{include});
  CHECK(verdict.answer() == Answer::unknown);
  CHECK(verdict.unknown_rules == std::vector<const Rule*>{include.rule});
  const Diagnostic sensor = at("SML1447", "/robot/gazebo/sensor", "sdf");
  CHECK(judge_target(*find_target("gazebo"), std::vector{sensor}).answer() == Answer::refuses);
}

TEST_CASE("what no target is asked about concerns none") {
  CHECK(judge_target(*find_target("ros"), std::vector{at("SML9001", "/targets")}).answer() ==
        Answer::takes);
  const std::vector<Diagnostic> motor = {at("SML3101", "/motors/0/joint")};
  CHECK(judge_target(*find_target("ros"), motor).answer() == Answer::takes);
  CHECK(judge_target(*find_target("mars"), motor).answer() == Answer::loses);
}

TEST_CASE("a slip is also what it leaves out") {
  Diagnostic slip = at("SML1107", "/robot/joint/limit/@efrot");
  CHECK(effect_of("ros", slip) == Effect::changes);
  slip.consequences.push_back(find_rule("SML1404"));
  CHECK(effect_of("ros", slip) == Effect::refuses);
  CHECK(severity_for(slip, {"ros"}) == Severity::error);
}

TEST_CASE("what is written for a reader is nothing to report where no other matters") {
  const auto count_for = [](std::vector<std::string_view> targets) {
    RuleSelection selection;
    for (const std::string_view name : targets) selection.targets.push_back(find_target(name));
    SourceMap sources;
    Diagnostic placed = at("SML1201", "/robot/joint/parent/@link", "drake-world");
    placed.span.source = sources.add("robot.urdf", "");
    return finish({placed}, sources, selection).size();
  };
  CHECK(count_for({}) == 1);
  CHECK(count_for({"drake"}) == 0);
  CHECK(count_for({"ros"}) == 1);
  CHECK(count_for({"drake", "ros"}) == 1);
  const Diagnostic plain = at("SML1201", "/robot/joint/parent/@link");
  CHECK(severity_for(plain, {"drake"}) == Severity::error);
}

TEST_CASE("what readers do is said by facts, and not in the words of a rule as well") {
  for (const Rule* rule : all_rules()) {
    const auto is_named = [&](const std::string& program) {
      const std::size_t at = rule->why.find(program);
      return at != std::string_view::npos &&
             (at == 0 || !std::isalnum(static_cast<unsigned char>(rule->why[at - 1])));
    };
    std::vector<std::string> programs = {"sdformat", "Bullet"};
    for (const Reader* reader : all_readers()) {
      if (reader->name == "urdf" || reader->name == "ros") continue;
      programs.emplace_back(reader->title.substr(0, reader->title.find(' ')));
    }
    const bool is_said = std::any_of(programs.begin(), programs.end(), is_named);
    CHECK_MESSAGE(!is_said, rule->id << ": " << rule->why);
    for (const Reader* reader : all_readers()) {
      if (reader->version.empty()) continue;
      for (const std::string_view text : {rule->why, rule->sources, rule->summary}) {
        CHECK_MESSAGE(text.find(reader->version) == std::string_view::npos,
                      rule->id << " says the version of " << reader->title);
      }
    }
  }
}
