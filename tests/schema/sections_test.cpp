// SPDX-License-Identifier: BSD-3-Clause
// The values that the section readers keep, and their messages.
#include <doctest/doctest.h>

#include "ast/model_reader.hpp"
#include "ast/sections.hpp"
#include "schema/case_file.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

struct Wording {
  std::string message, help, edit;
};

Wording first_finding(const std::string& entry) {
  const Reading reading(FileKind::annotations, "motors:\n- {name: a, joint: b, " + entry + "}\n");
  const auto findings = reading.shape_findings();
  if (findings.empty()) return {};
  const auto& fixes = findings[0]->fixes;
  return {findings[0]->message, findings[0]->help_text,
          fixes.empty() ? "" : fixes[0].edits.at(0).text};
}

struct Read {
  Reading reading;
  Annotations annotations;
  explicit Read(const std::string& text) : reading(FileKind::annotations, text) {
    DiagnosticSink ignored;
    annotations = *read_annotations(*reading.document, ignored);
  }
};

}  // namespace

TEST_CASE("messages say what is written and what to write") {
  const Wording in_quotes = first_finding("p: '7'");
  CHECK(in_quotes.message == "`p` must be a number, not `7`, which is quoted and therefore text");
  CHECK(in_quotes.edit == "7");
  CHECK(first_finding("p: 45deg").message == "`p` must be a number, not the text `45deg`");
  CHECK(first_finding("p: [1]").message == "`p` must be a number, not a list");
  CHECK(first_finding("maxSpeed: -1").message == "`maxSpeed` is -1, but must be at least 0");
  CHECK(first_finding("noDataPackage: yes").edit == "true");
  CHECK(first_finding("noDataPackage: 'false'").edit == "false");
  CHECK(first_finding("noDataPackage: 2").message ==
        "`noDataPackage` must be true or false, not `2`");
  CHECK(first_finding("jointIndex2: 1.5").message ==
        "`jointIndex2` must be a whole number, not `1.5`");
  CHECK(first_finding("jointIndex2: 10.0").message == "");
  CHECK(first_finding("maxeffort_approximation: polynom22").help == "did you mean `polynom2`?");
  CHECK(first_finding("name: ~").message == "");
}

TEST_CASE("a null says nothing, so a required key stays missing") {
  const Reading reading(FileKind::annotations, "motors: [{name: a, joint: ~}]\n");
  REQUIRE(reading.shape_findings().size() == 1);
  CHECK(reading.shape_findings()[0]->message == "this motor has no `joint`");
}

TEST_CASE("a misspelt required key is one finding, at the key") {
  const Reading reading(FileKind::annotations, "motors: [{name: a, jiont: b}]\n");
  REQUIRE(reading.shape_findings().size() == 1);
  const Diagnostic& finding = *reading.shape_findings()[0];
  CHECK(finding.message == "this motor has no `joint`");
  CHECK(finding.help_text == "did you mean `joint` by `jiont`?");
  CHECK(reading.sources.text(finding.span) == "jiont");

  const Reading json(FileKind::annotations, R"({"joint": [{"name": "j", "type": "slidr"}]})");
  const Edit& edit = json.shape_findings().at(0)->fixes.at(0).edits.at(0);
  CHECK(json.sources.text(edit.span) == "slidr");
  CHECK(edit.text == "slider");
}

TEST_CASE("a main file needs `files`") {
  const Reading misspelt(FileKind::model, "modelname: a\nflies: [a.urdf]\n");
  REQUIRE(misspelt.shape_findings().size() == 1);
  const Diagnostic& finding = *misspelt.shape_findings()[0];
  CHECK(finding.message == "this main file has no `files`");
  CHECK(misspelt.sources.text(finding.span) == "flies");
  CHECK(finding.help_text == "did you mean `files` by `flies`?");

  const Reading absent(FileKind::model, "modelname: a\n");
  REQUIRE(absent.shape_findings().size() == 1);
  CHECK(absent.sources.text(absent.shape_findings()[0]->span) == "modelname");
  CHECK(Reading(FileKind::model, "files: []\n").shape_findings().empty());
}

TEST_CASE("every section is found by its names") {
  for (const std::string_view name : section_names()) {
    CAPTURE(name);
    CHECK(find_section(name) != nullptr);
  }
  for (const auto& [alias, name] : {std::pair{"joints", "joint"},
                                    {"links", "link"},
                                    {"collisions", "collision"},
                                    {"material", "materials"}}) {
    CHECK(find_section(alias) == find_section(name));
  }
  CHECK(find_section("pose") == nullptr);
}

TEST_CASE("values are kept with their places") {
  const Read read("joints: [{name: j, axis1: {z: 1}, parent: p}]\n"
                  "collision: [{name: c, bitmask: 7, ccfm: 0.1}]\n"
                  "joint_tasks: [{name: j, provider: frames, port: j_pose, driver: arm}]\n"
                  "sensors: [{name: s, type: NodeIMU, id: [a, 2]}]\n"
                  "interfaces: [{name: i, parent: l, position: [1, 2, 3]}]\n");
  const Annotations& all = read.annotations;
  REQUIRE(all.joints.size() == 1);
  CHECK(read.reading.sources.text(all.joints[0].section) == "joints");
  CHECK(all.joints[0].axis->at(2) == 1);
  CHECK(*all.joints[0].parent == "p");
  CHECK(*all.joint_tasks.at(0).port == "j_pose");
  CHECK(*all.collisions.at(0).bitmask == 7);
  REQUIRE(all.sensors.at(0).id->size() == 2);
  CHECK(all.sensors[0].id->at(1).value == "2");
  CHECK(all.interfaces.at(0).position->at(1) == 2);
  CHECK(!all.interfaces[0].rotation.written);
}

TEST_CASE("joint poses keep the order of the file and the first of two equal names") {
  const Read read("poses: [{name: up, joints: {b: 0.5, a: x, b: 2, c: ~}}]\n");
  const auto& joints = read.annotations.poses.at(0).joints;
  REQUIRE(joints.size() == 2);
  CHECK(joints[0].name.value == "b");
  CHECK(*joints[0].position == 0.5);
  CHECK(joints[1].name.value == "a");
  CHECK(joints[1].position.written);
  CHECK(!joints[1].position);
}

TEST_CASE("graphics is a list or one mapping, submodels are named by their keys") {
  CHECK(Read("graphics: {fogStart: 3}\n").annotations.graphics.size() == 1);
  CHECK(Read("graphics: [{fogStart: 3}, {fogEnd: 4}]\n").annotations.graphics.size() == 2);
  const Read read("submodels: {left: {start: l, stop: [a, b]}, right: {start: r, stop: c}}\n");
  const auto& submodels = read.annotations.submodels;
  REQUIRE(submodels.size() == 2);
  CHECK(*submodels[0].name == "left");
  CHECK(submodels[0].stop->size() == 2);
  CHECK(*submodels[1].start == "r");
  CHECK(submodels[1].stop->size() == 1);
}

TEST_CASE("one section's entries add up, other sections are kept whole") {
  const Read read("motors: [{name: a, joint: a}]\nmotor: [{name: b, joint: b}]\nmine: [1]\n");
  CHECK(read.annotations.motors.size() == 2);
  REQUIRE(read.annotations.custom.size() == 1);
  CHECK(read.annotations.custom[0].name.value == "mine");
}
