// SPDX-License-Identifier: BSD-3-Clause
// The hand-written schemas accept the output of the tools and reject near misses.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <span>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "ast/urdf_schema.hpp"
#include "schema/case_file.hpp"
#include "schema/validator.hpp"
#include "smurf/check.hpp"
#include "smurf/diff.hpp"
#include "smurf/render.hpp"
#include "smurf/write.hpp"
#include "support/temporary_folder.hpp"

using Json = nlohmann::json;
using namespace nlohmann::literals;
using namespace smurf;
using namespace smurf::test;

namespace {

/// A change to a sound document, by JSON merge patch: a null removes the key.
struct Miss {
  const char* pointer;  ///< place of the changed object
  const char* patch;
};

void check(const std::string& schema, const Json& sound, std::initializer_list<Miss> misses) {
  std::vector<test::Instance> instances{{schema, sound.dump()}};
  for (const Miss& miss : misses) {
    Json changed = sound;
    changed.at(Json::json_pointer(miss.pointer)).merge_patch(Json::parse(miss.patch));
    instances.push_back({schema, changed.dump()});
  }
  const auto verdicts = validate(instances);
  if (!verdicts) {
    MESSAGE("skipped: python3-jsonschema is not installed (scripts/setup)");
    return;
  }
  CHECK((*verdicts)[0]);
  for (std::size_t i = 1; i < verdicts->size(); ++i) {
    CAPTURE(instances[i].json);
    CHECK_FALSE((*verdicts)[i]);
  }
}

}  // namespace

TEST_CASE("the report of diagnostics") {
  const Reading reading(FileKind::annotations, "motors:\n- {name: a, joint: b, p: '1', i: -0x}\n");
  std::vector<Diagnostic> diagnostics(reading.sink.diagnostics().begin(),
                                      reading.sink.diagnostics().end());
  REQUIRE(diagnostics.size() == 2);
  diagnostics[0].label(diagnostics[1].span, "see here");
  diagnostics[0].note("a note");
  diagnostics[0].pointer = "/motors/0/p";
  const std::span<const Fact> facts = find_rule("SML1012")->facts;
  const auto refusal = std::find_if(
      facts.begin(), facts.end(), [](const Fact& fact) { return fact.effect == Effect::refuses; });
  const TargetVerdict refused{.reader = find_target("mars"),
                              .refusals = 1,
                              .fact = &*refusal,
                              .rule = diagnostics[0].rule,
                              .span = diagnostics[0].span};
  const TargetVerdict taken{
      .reader = find_target("ros"), .unknown = 1, .unknown_rules = {diagnostics[0].rule}};
  const Json report =
      Json::parse(render_json(diagnostics, reading.sources, summarize(diagnostics),
                              {"smurf-lint", "0.1.0"}, std::vector{refused, taken}));
  check("lint-report.schema.json", report,
        {{"", R"({"tool": null})"},
         {"", R"({"schema_version": "2.0"})"},
         {"", R"({"more": 1})"},
         {"/summary", R"({"error": -1})"},
         {"/summary", R"({"models": null})"},
         {"/targets/mars", R"({"verdict": "maybe"})"},
         {"/targets/ros", R"({"losses": null})"},
         {"/targets/mars/first", R"({"source": null})"},
         {"/diagnostics/0", R"({"id": "SML401"})"},
         {"/diagnostics/0", R"({"severity": "fatal"})"},
         {"/diagnostics/0", R"({"line": 0})"},
         {"/diagnostics/0", R"({"rule": "x"})"},
         {"/diagnostics/0/fix", R"({"edits": []})"},
         {"/diagnostics/0/fix/edits/0", R"({"end": null})"},
         {"/diagnostics/0/labels/0", R"({"message": null})"}});
}

TEST_CASE("the report of losses") {
  const Reading reading(FileKind::annotations, "motors:\n- {name: a, joint: b, p: 3}\n");
  DiagnosticSink sink;
  sink.report(*find_rule("SML8001"), {SourceId{0}, 10, 12}, "`p` has no place").pointer = "/a";
  const Json report =
      Json::parse(render_losses_json(sink.take(), reading.sources, {"smurf2urdf", "0.1.0"}));
  check("loss-report.schema.json", report,
        {{"", R"({"losses": null})"},
         {"", R"({"summary": {}})"},
         {"/losses/0", R"({"class": "vendor"})"},
         {"/losses/0", R"({"id": "SML3101"})"},
         {"/losses/0", R"({"pointer": null})"},
         {"/losses/0", R"({"line": 0})"}});
}

TEST_CASE("the report of differences") {
  SourceMap sources;
  const SourceId id = sources.add("r.urdf", "<robot/>");
  const Span place{id, 1, 6};
  static constexpr std::string_view kParts[] = {"ixx", "iyy"};
  const std::vector<Difference> differences = {
      {.kind = "joint",
       .name = "elbow",
       .property = "pose",
       .before = Pose{},
       .after = Pose{},
       .detail = "moves 7 links",
       .old_place = place,
       .new_place = place},
      {.kind = "link",
       .property = "inertial.inertia",
       .before = std::monostate{},
       .after = std::vector<double>{1, 2},
       .fallback = "0",
       .unit = "kg m^2",
       .parts = kParts,
       .old_place = place,
       .new_place = place},
      {.kind = "node",
       .property = "rotation",
       .before = Quaternion{},
       .after = std::vector<std::string>{"a"},
       .old_place = place,
       .new_place = place},
      {.change = Change::renamed,
       .kind = "link",
       .name = "b",
       .old_name = "a",
       .old_place = place,
       .new_place = place},
      {.change = Change::added,
       .kind = "visual",
       .owner = "link hand",
       .number = 2,
       .new_place = place},
      {.change = Change::removed, .kind = "motor", .name = "m", .old_place = place}};
  const Json report = Json::parse(render_diff_json(
      differences, sources, {"old.urdf", "r.urdf", 1e-9}, {"smurf-diff", "0.1.0"}));
  check("diff-report.schema.json", report,
        {{"", R"({"summary": null})"},
         {"", R"({"tolerance": -1})"},
         {"/summary", R"({"changed": null})"},
         {"/differences/0", R"({"change": "moved"})"},
         {"/differences/0", R"({"property": null})"},
         {"/differences/0", R"({"new": {"position": [0, 0]}})"},
         {"/differences/0", R"({"old_name": "x"})"},
         {"/differences/0/new_source", R"({"line": 0})"},
         {"/differences/3", R"({"old_name": null})"},
         {"/differences/4", R"({"old_source": {"file": "a", "line": 1, "column": 1}})"},
         {"/differences/4", R"({"number": 0})"},
         {"/differences/5", R"({"old": 1})"}});
}

TEST_CASE("the flat scene") {
  const Json scene = Json::parse(R"({
    "schema_version": "1.0", "scene": "example.smurfs", "frame": "world",
    "physics": {"gravity": [0, 0, -9.81]}, "environment": {}, "lights": [],
    "models": [{"id": "arm", "type": "smurf", "file": "arm.smurf", "urdf": "urdf/arm.urdf"}],
    "instances": [
      {"name": "Eve", "path": "cell/Eve", "type": "smurf", "model": "arm",
       "source": {"file": "example.smurfs", "line": 4},
       "position": [5.0, 0.0, -0.8], "orientation": {"w": 1, "x": 0, "y": 0, "z": 0},
       "anchor": {"instance": "Base", "link": "flange"}, "parent": "world",
       "joint_positions": {"elbow": 0.5}, "properties": {"color": "red"},
       "links": {"hand": {"position": [0, 0, 0],
                          "orientation": {"w": 1, "x": 0, "y": 0, "z": 0}}}}]})");
  check("flat-scene.schema.json", scene,
        {{"", R"({"frame": "map"})"},
         {"", R"({"instances": null})"},
         {"/physics", R"({"gravity": [0, 0]})"},
         {"/models/0", R"({"id": ""})"},
         {"/instances/0", R"({"position": [0, 0]})"},
         {"/instances/0", R"({"orientation": [1, 0, 0, 0]})"},
         {"/instances/0/orientation", R"({"w": -0.5})"},
         {"/instances/0/orientation", R"({"w": null})"},
         {"/instances/0", R"({"anchor": "parent"})"},
         {"/instances/0/anchor", R"({"link": null})"},
         {"/instances/0", R"({"parent": "none"})"},
         {"/instances/0", R"({"joint_positions": {"elbow": "0.5"}})"},
         {"/instances/0/source", R"({"line": 0})"},
         {"/instances/0", R"({"color": "red"})"},
         {"/instances/0/links/hand", R"({"position": null})"}});
}

namespace {

Json dump_of_model(const std::string& path) {
  Session session;
  const LoadedModel loaded = session.load_model(path);
  return Json::parse(*write_model_json(loaded.model, *loaded.sources));
}

/// An element of URDF with all attributes and children; each shape is that of a visual.
std::string whole_element(std::string_view name, std::string_view shape = "box") {
  const urdf::ElementSpec& spec = *urdf::find_element_spec(name);
  std::string text = "<" + std::string(name);
  for (const urdf::AttributeSpec& attribute : spec.attributes) {
    std::string_view value = "1";
    if (attribute.form == urdf::Form::three_numbers) value = "1 2 3";
    if (attribute.form == urdf::Form::four_numbers) value = "0 0 0 1";
    if (!attribute.values.empty()) value = attribute.values.front();
    text.append(" ").append(attribute.name).append("=\"").append(value).append("\"");
  }
  text += ">";
  for (const urdf::ChildSpec& child : spec.children) {
    if (name == "geometry" && child.name != shape) continue;
    if (child.name != "visual") {
      text += whole_element(child.name, shape);
      continue;
    }
    for (const urdf::ChildSpec& one : urdf::find_element_spec("geometry")->children) {
      text += whole_element(child.name, one.name);
    }
  }
  return text.append("</").append(name).append(">");
}

Json dump_of_scene(const std::string& path) {
  Session session;
  const LoadedScene loaded = session.load_scene(path);
  return Json::parse(*write_scene_json(loaded.scene, *loaded.sources));
}

}  // namespace

TEST_CASE("the dump of a model") {
  const Json dump = dump_of_model(SMURF_FIXTURES "/models/arm/smurf/arm.smurf");
  const Json& model = dump.at("model");
  CHECK(model.at("joints").size() == 9);
  CHECK(model.at("annotations").at("motors").size() == 6);
  check("model-dump.schema.json", dump,
        {{"", R"({"model": null})"},
         {"", R"({"scene": {}})"},
         {"", R"({"schema_version": "2.0"})"},
         {"/model", R"({"joints": null})"},
         {"/model", R"({"colour": 1})"},
         {"/model/files/0", R"({"kind": "mesh"})"},
         {"/model/links/1", R"({"source": null})"},
         {"/model/links/1/source", R"({"line": 0})"},
         {"/model/links/1/inertial", R"({"mass": "1"})"},
         {"/model/links/1/inertial/inertia", R"({"iyx": 0})"},
         {"/model/links/1/visuals/0", R"({"X_LC": null, "X_LV": null})"},
         {"/model/links/1/visuals/0/X_LV", R"({"position": [0, 0]})"},
         {"/model/links/1/visuals/0/X_LV/orientation", R"({"w": 2})"},
         {"/model/links/1/visuals/0/geometry", R"({"type": "cone"})"},
         {"/model/joints/0", R"({"type": "hinge"})"},
         {"/model/annotations/motors/0", R"({"values": []})"}});
}

TEST_CASE("the dump of a robot with every attribute of URDF") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "every.urdf";
  std::ofstream(path) << whole_element("robot");
  const Json dump = dump_of_model(path);
  check("model-dump.schema.json", dump,
        {{"/model/joints/0/safety_controller", R"({"k_position": "1"})"},
         {"/model/joints/0/calibration", R"({"edge": 1})"}});
  const Json schema = Json::parse(std::ifstream(SMURF_SCHEMAS "/model-dump.schema.json"));
  const Json& parts = schema.at("/definitions/joint/properties"_json_pointer);
  for (const char* part : {"limit", "dynamics", "mimic", "safety_controller", "calibration"}) {
    CAPTURE(part);
    CHECK(dump.at("model").at("joints").at(0).at(part).size() ==
          parts.at(part).at("properties").size());
  }
}

TEST_CASE("the dump of a scene") {
  const Json dump = dump_of_scene(SMURF_FIXTURES "/scenes/nested/outer.smurfs");
  const Json& scene = dump.at("scene");
  CHECK(scene.at("files").size() == 3);
  CHECK(scene.at("instances").size() == 5);
  check("model-dump.schema.json", dump,
        {{"/scene", R"({"models": null})"},
         {"/scene/files/0/entities/0", R"({"list": "robots"})"},
         {"/scene/instances/0", R"({"path": null})"},
         {"/scene/instances/0", R"({"model": -1})"},
         {"/scene/instances/0", R"({"anchor": "parent"})"},
         {"/scene/instances/0", R"({"joint_positions": {"j1": "0.5"}})"},
         {"/scene/models/0", R"({"is_complete": 1})"}});
}

TEST_CASE("the dumps of all fixtures, whatever is wrong in them") {
  std::vector<test::Instance> instances;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SMURF_FIXTURES)) {
    const std::string extension = entry.path().extension().string();
    const std::string path = entry.path().string();
    if (extension == ".smurf" || extension == ".urdf") {
      instances.push_back({"model-dump.schema.json", dump_of_model(path).dump()});
    } else if (extension == ".smurfs" || extension == ".smurfa" || extension == ".svg") {
      instances.push_back({"model-dump.schema.json", dump_of_scene(path).dump()});
    }
  }
  REQUIRE(instances.size() > 1000);
  const auto verdicts = validate(instances);
  if (!verdicts) return;
  for (std::size_t i = 0; i < verdicts->size(); ++i) {
    CAPTURE(instances[i].json);
    CHECK((*verdicts)[i]);
  }
}

TEST_CASE("the report of the load check") {
  const Json report = Json::parse(R"({
    "schema_version": "1.0", "tool": {"name": "smurf-load-check", "version": "0.1.0"},
    "summary": {"error": 0}, "diagnostics": [],
    "checks": [
      {"file": "arm.urdf", "kind": "model", "verdict": "pass", "stages": [
        {"stage": "BUILD", "verdict": "pass", "note": "1 moving body", "figures": []},
        {"stage": "HANG", "verdict": "pass", "figures": [
          {"name": "gap", "value": 1e-6, "bound": 1e-3, "unit": "m", "is_within": true,
           "worst": {"name": "joint `a`", "file": "arm.urdf", "line": 7}}]}]}]})");
  check("load-report.schema.json", report,
        {{"", R"({"checks": null})"},
         {"", R"({"diagnostics": [{"id": "SML6101"}]})"},
         {"/checks/0", R"({"verdict": "skipped"})"},
         {"/checks/0", R"({"kind": "robot"})"},
         {"/checks/0/stages/0", R"({"stage": "FLY"})"},
         {"/checks/0/stages/1/figures/0", R"({"value": "nan"})"},
         {"/checks/0/stages/1/figures/0", R"({"name": "gaps"})"},
         {"/checks/0/stages/1/figures/0", R"({"is_within": null})"},
         {"/checks/0/stages/1/figures/0/worst", R"({"line": 0})"}});
}
