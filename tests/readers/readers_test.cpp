// SPDX-License-Identifier: BSD-3-Clause
// The table of readers, and the effect of targets on findings.
#include "smurf/verdict.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <set>

#include "base/findings/cases.hpp"
#include "base/findings/place_names.hpp"
#include "base/findings/uncertain.hpp"
#include "readers/circumstances.hpp"
#include "smurf/check.hpp"
#include "support/loaded.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

Diagnostic found(std::string_view rule, std::string pointer,
                 std::initializer_list<const Circumstance*> cases = {}) {
  Diagnostic diagnostic;
  diagnostic.rule = find_rule(rule);
  diagnostic.severity = diagnostic.rule->severity;
  diagnostic.pointer = std::move(pointer);
  for (const Circumstance* one : cases) diagnostic.when(*one);
  return diagnostic;
}

/// A case of a rule, by the name that users see.
const Circumstance* case_of(std::string_view rule, std::string_view name) {
  for (const Fact& fact : find_rule(rule)->facts) {
    for (const Circumstance* one : fact.where.cases) {
      if (one != nullptr && one->name == name) return one;
    }
  }
  FAIL("there is no such case");
  return nullptr;
}

void check_text(const Fact& fact) {
  CAPTURE(fact.makes);
  REQUIRE(fact.reader != nullptr);
  CHECK(!fact.makes.empty());
  CHECK(!fact.makes.ends_with('.'));
  CHECK(!fact.evidence.empty());
  CHECK((fact.evidence != kRun || !fact.reader->version.empty()));
}

/// Whether everything that fits `inner` fits `outer`.
bool covers(const Where& outer, const Where& inner) {
  const auto end = std::find(inner.place.begin(), inner.place.end(), PlaceName{});
  const auto needs = [&](const Circumstance* one) { return one == nullptr || inner.needs(*one); };
  const bool is_in_versions =
      outer.from <= inner.from &&
      (outer.until == Version{} || (inner.until != Version{} && inner.until <= outer.until));
  return contains({inner.place.begin(), end}, outer) && is_in_versions &&
         std::all_of(outer.cases.begin(), outer.cases.end(), needs) &&
         (outer.except == nullptr || outer.except == inner.except);
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
  const std::vector<Diagnostic> finished = apply_selection({placed}, sources, selection);
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
      const std::string_view family = one.family.id();
      const Fact& fact = one.fact;
      CAPTURE(family);
      check_text(fact);
      CHECK(fact.reader == reader);
      CHECK(std::any_of(all_rules().begin(), all_rules().end(),
                        [&](const Rule* rule) { return one.family.covers(*rule); }));
    }
    for (const Fact& fact : reader->unread) {
      check_text(fact);
      CHECK(fact.reader == reader);
      CHECK(fact.where != Where{});
      CHECK(fact.effect == Effect::ignores);
    }
  }
}

TEST_CASE("every fact says something, and can be reached") {
  for (const Rule* rule : all_rules()) {
    CAPTURE(rule->id);
    for (std::size_t i = 0; i < rule->facts.size(); ++i) {
      const Fact& fact = rule->facts[i];
      CAPTURE(describe(fact.where));
      check_text(fact);
      for (std::size_t k = 0; k < i; ++k) {
        const Fact& before = rule->facts[k];
        const bool hides = fact.reader == before.reader && covers(before.where, fact.where);
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
  for (const Reader* reader : all_readers()) {
    CAPTURE(reader->name);
    const bool is_named = std::find(names.begin(), names.end(), reader->name) != names.end();
    CHECK(is_named == reader->is_target);
    CHECK((find_target(reader->name) == reader) == reader->is_target);
  }
}

TEST_CASE("facts see the path without names and indices") {
  const auto names = [](const char* pointer) {
    std::string text;
    for (const PlaceName name : place_of(found("SML1802", pointer))) {
      text.append("/").append(name == PlaceName{} ? "?" : to_string(name));
    }
    return text;
  };
  CHECK(names("/robot/link[@name='a/[b]']/inertial/mass/@value") ==
        "/robot/link/inertial/mass/@value");
  CHECK(names("/motors/12/type") == "/motors/type");
  CHECK(names("/robot/xacro:if/joint/@unheard") == "/robot/xacro:/joint/@");
  CHECK(names("/robot/unheard") == "/robot/?");
  CHECK(names("") == "");
}

TEST_CASE("names that users give are no places of facts") {
  for (const char* joint : {"rotation", "position", "elbow", "physics", "joints"}) {
    CAPTURE(joint);
    const std::string pointer = std::string("/poses/0/joints/") + joint;
    const Diagnostic text = found("SML4001", pointer, {&cases::kValueWanted, &cases::kIsText});
    CHECK(effect_of("phobos", text) == Effect::ignores);
    CHECK(effect_of("mars", text) == Effect::ignores);
  }
  const Diagnostic of_scene =
      found("SML4001", "/entities/0/rotation", {&cases::kValueWanted, &cases::kIsText});
  CHECK(effect_of("phobos", of_scene) == Effect::refuses);
}

TEST_CASE("the order of cases does not count") {
  const std::string mass = "/robot/link[@name='a']/inertial/mass/@value";
  const auto effect = [&](std::initializer_list<const Circumstance*> cases) {
    return effect_of("mujoco", found("SML1809", mass, cases));
  };
  CHECK(effect({&cases::kHex, &cases::kZeroOrLess, &kAlone}) == Effect::refuses);
  CHECK(effect({&kAlone, &cases::kZeroOrLess, &cases::kHex}) == Effect::refuses);
  CHECK(effect({&kAlone, &cases::kHex}) == Effect::changes);
}

TEST_CASE("a reader that drops a part has no facts about it, but what it is built on has") {
  const std::string limit = "/robot/joint[@name='j']/limit";
  CHECK(effect_of("gazebo", found("SML1209", limit)) == Effect::loses);
  CHECK(effect_of("gazebo", found("SML1209", limit, {&kDroppedByGazebo})) == Effect::takes);
  CHECK(effect_of("gazebo", found("SML1403", limit, {&kDroppedByGazebo})) == Effect::refuses);
}

TEST_CASE("facts hold for the version that a target names") {
  CHECK(find_target("ros:jazzy")->title == "ROS Jazzy");
  CHECK(find_target("ros:hydro") == nullptr);
  CHECK(find_target("mujoco:3.14") != nullptr);
  const auto effect = [](const char* target, const char* version) {
    return effect_of(target, found("SML1104", "/robot/@version", {case_of("SML1104", version)}));
  };
  for (const char* version : {"1.1", "1.2"}) {
    CAPTURE(version);
    CHECK(effect("ros", version) == Effect::refuses);
    CHECK(effect("ros:humble", version) == Effect::refuses);
    CHECK(effect("ros:jazzy", version) == Effect::refuses);
    CHECK(effect("ros:rolling", version) == Effect::takes);
    CHECK(effect("gazebo", version) == Effect::refuses);
  }
  const Diagnostic unheard = found("SML1104", "/robot/@version");
  CHECK(effect_of("ros:rolling", unheard) == Effect::refuses);
}

TEST_CASE("what is written for a later release is nothing to report where only it matters") {
  const auto count_for = [](const char* target) {
    RuleSelection selection;
    selection.targets = {find_target(target)};
    SourceMap sources;
    Diagnostic placed = found("SML1104", "/robot/@version", {case_of("SML1104", "1.2")});
    placed.span.source = sources.add("robot.urdf", "");
    return apply_selection({placed}, sources, selection).size();
  };
  CHECK(count_for("ros:rolling") == 0);
  CHECK(count_for("ros:jazzy") == 1);
  CHECK(count_for("ros") == 1);
}

TEST_CASE("a verdict says when a later release differs") {
  const std::vector<Diagnostic> dated = {
      found("SML1104", "/robot/@version", {case_of("SML1104", "1.2")})};
  const TargetVerdict ros = judge_target(*find_target("ros"), dated);
  CHECK(ros.answer() == Answer::refuses);
  REQUIRE(ros.newer.size() == 2);
  REQUIRE(find_other_release(ros) != nullptr);
  CHECK(find_other_release(ros)->reader->name == "ros:rolling");
  CHECK(find_other_release(ros)->answer() == Answer::takes);
  CHECK(find_other_release(judge_target(*find_target("ros:jazzy"), dated)) == nullptr);

  TargetVerdict sum{.reader = find_target("ros")};
  sum.add(judge_target(*find_target("ros"), {}));
  CHECK(find_other_release(sum) == nullptr);
  sum.add(ros);
  CHECK(find_other_release(sum)->answer() == Answer::takes);
  sum.add(judge_target(*find_target("ros"), std::vector{found("SML1403", "/robot/joint")}));
  CHECK(sum.refusals == 2);
  CHECK(find_other_release(sum) == nullptr);  // both refuse the second file
}

TEST_CASE("the first fact that fits wins, then those of what a reader is built on") {
  const Diagnostic in_link = found("SML1801", "/robot/link[@name='a']/inertial/mass/@value");
  const Diagnostic in_joint = found("SML1801", "/robot/joint[@name='j']/limit/@effort");
  CHECK(effect_of("ros", in_link) == Effect::breaks);
  CHECK(effect_of("ros", in_joint) == Effect::refuses);
  CHECK(effect_of("dart", in_joint) == Effect::refuses);
  CHECK(effect_of("pybullet", in_joint) == Effect::changes);
  CHECK(effect_of("gazebo", found("SML1206", "/robot")) == Effect::refuses);
  CHECK(effect_of("ros", found("SML1206", "/robot")) == Effect::changes);
  CHECK(effect_of("mujoco", found("SML1115", "/robot")) == Effect::takes);
  CHECK(effect_of("ros", found("SML1115", "/robot")) == Effect::refuses);
}

TEST_CASE("what a reader does not look at it takes, unless it cannot read the file") {
  const std::string size = "/robot/link[@name='a']/visual/geometry/box/@size";
  CHECK(effect_of("mujoco", found("SML1801", size)) == Effect::ignores);
  CHECK(effect_of("mujoco", found("SML1007", size)) == Effect::refuses);
  CHECK(effect_of("mujoco", found("SML1801", size, {&kVisualsKept})) == Effect::refuses);
  CHECK(effect_of("ros", found("SML1801", size)) == Effect::breaks);
}

TEST_CASE("no target loads a robot that xacro cannot make") {
  for (const Rule* rule : all_rules()) {
    if (!rule->id.starts_with("SML33")) continue;
    for (const Reader* reader : all_readers()) {
      CAPTURE(rule->id);
      CAPTURE(reader->name);
      const Answer answer = judge_target(*reader, std::vector{found(rule->id, "/robot")}).answer();
      CHECK(answer == (rule->may_pass_elsewhere ? Answer::unknown : Answer::refuses));
    }
  }
}

TEST_CASE("the severity is that of the worst target") {
  const Diagnostic bounds_equal = found("SML1408", "/robot/joint/limit/@upper");
  CHECK(severity_for(bounds_equal, {}) == Severity::warning);
  CHECK(severity_for(bounds_equal, {"mujoco"}) == Severity::warning);
  CHECK(severity_for(bounds_equal, {"ros"}) == Severity::warning);  // nobody means such a joint
  const Diagnostic effort_missing =
      found("SML1404", "/robot/joint/limit", {case_of("SML1404", "effort")});
  CHECK(severity_for(effort_missing, {"ros"}) == Severity::error);
  CHECK(severity_for(effort_missing, {"pybullet"}) == Severity::warning);
  CHECK(severity_for(effort_missing, {"pybullet", "ros"}) == Severity::error);
  CHECK(severity_for(effort_missing, {"mujoco"}) == Severity::warning);  // takes: one level milder
  const Diagnostic too_large = found("SML0002", "/robot");
  CHECK(severity_for(too_large, {"mujoco"}) == Severity::error);  // the target may refuse it
  CHECK(severity_for(found("SML1407", "/robot/joint/limit"), {"drake"}) == Severity::error);
  CHECK(severity_for(found("SML1407", "/robot/joint/limit"), {"mars"}) == Severity::error);
}

TEST_CASE("what no body can be stays an error, and what nobody knows stays as it is") {
  CHECK(severity_for(found("SML1513", "/robot/link/inertial"), {"pybullet"}) == Severity::error);
  CHECK(severity_for(found("SML1411", "/robot/joint/limit"), {"ros"}) == Severity::warning);
  CHECK(!has_facts(*find_rule("SML1411")));
}

TEST_CASE("--severity has the last word") {
  RuleSelection selection;
  selection.targets = {find_target("ros")};
  selection.severities["SML1404"] = Severity::info;
  SourceMap sources;
  Diagnostic finding = found("SML1404", "/robot/joint/limit");
  finding.span.source = sources.add("robot.urdf", "");
  CHECK(apply_selection({finding}, sources, selection)[0].severity == Severity::info);
}

TEST_CASE("notes say what the targets make of it, equal ones once") {
  RuleSelection selection;
  selection.targets = {find_target("ros"), find_target("dart"), find_target("pybullet")};
  SourceMap sources;
  Diagnostic finding = found("SML1404", "/robot/joint/limit", {case_of("SML1404", "effort")});
  finding.span.source = sources.add("robot.urdf", "");
  CHECK(apply_selection({finding}, sources, selection)[0].notes ==
        std::vector<std::string>{"ros, dart: refuses the file",
                                 "pybullet: reads 0: the joint has no force"});
}

TEST_CASE("verdicts count refusals and losses, and name the worst") {
  const std::vector<Diagnostic> findings = {found("SML1408", "/robot/joint/limit/@upper"),
                                            found("SML1409", "/robot/joint/limit"),
                                            found("SML1403", "/robot/joint")};
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

TEST_CASE("an error of which nothing is known is no reason to say that a reader loads the file") {
  Diagnostic unknown = found("SML0002", "/robot");
  REQUIRE(unknown.severity == Severity::error);
  REQUIRE(find_fact(*find_target("ros"), unknown) == nullptr);
  const TargetVerdict verdict = judge_target(*find_target("ros"), std::vector{unknown, unknown});
  CHECK(verdict.answer() == Answer::unknown);
  CHECK(verdict.unknown == 2);
  CHECK(verdict.unknown_rules == std::vector<const Rule*>{unknown.rule});
  const std::vector<Diagnostic> worse = {unknown, found("SML1403", "/robot/joint")};
  CHECK(judge_target(*find_target("ros"), worse).answer() == Answer::refuses);
  const std::vector<Diagnostic> milder = {unknown, found("SML1406", "/robot/joint/limit")};
  CHECK(judge_target(*find_target("ros"), milder).answer() == Answer::unknown);
  unknown.severity = Severity::warning;
  CHECK(judge_target(*find_target("ros"), std::vector{unknown}).answer() == Answer::takes);
}

TEST_CASE("a refusal that depends on files outside of the model is not known") {
  const Diagnostic include = found("SML1447", "/robot/gazebo/include/uri", {&kUncertain});
  CHECK(severity_for(include, {"gazebo"}) == Severity::warning);
  const TargetVerdict verdict = judge_target(*find_target("gazebo"), std::vector{include});
  CHECK(verdict.answer() == Answer::unknown);
  CHECK(verdict.unknown_rules == std::vector<const Rule*>{include.rule});
  const Diagnostic sensor = found("SML1447", "/robot/gazebo/sensor");
  CHECK(judge_target(*find_target("gazebo"), std::vector{sensor}).answer() == Answer::refuses);
}

TEST_CASE("what no target is asked about concerns none") {
  CHECK(judge_target(*find_target("ros"), std::vector{found("SML9001", "/targets")}).answer() ==
        Answer::takes);
  const std::vector<Diagnostic> motor = {found("SML3101", "/motors/0/joint")};
  CHECK(judge_target(*find_target("ros"), motor).answer() == Answer::takes);
  CHECK(judge_target(*find_target("mars"), motor).answer() == Answer::loses);
}

TEST_CASE("a slip is also what it leaves out") {
  Diagnostic slip = found("SML1107", "/robot/joint/limit/@efrot");
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
    Diagnostic placed =
        found("SML1201", "/robot/joint/parent/@link", {case_of("SML1201", "world of Drake")});
    placed.span.source = sources.add("robot.urdf", "");
    return apply_selection({placed}, sources, selection).size();
  };
  CHECK(count_for({}) == 1);
  CHECK(count_for({"drake"}) == 0);
  CHECK(count_for({"ros"}) == 1);
  CHECK(count_for({"drake", "ros"}) == 1);
  const Diagnostic plain = found("SML1201", "/robot/joint/parent/@link");
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
