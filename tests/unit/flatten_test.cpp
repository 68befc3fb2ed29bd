// SPDX-License-Identifier: BSD-3-Clause
// Flat scenes: the contents of the tables, their output, and the sums of explanations.
#include <cmath>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "smurf/dialect.hpp"
#include "smurf/flatten.hpp"
#include "smurf/write.hpp"
#include "support/scenes.hpp"

using namespace smurf;
using namespace smurf::test;
using Json = nlohmann::ordered_json;

namespace {

const std::string kScenes = std::string(SMURF_FIXTURES) + "/scenes/";

Json to_json(const LoadedScene& loaded, const FlattenOptions& options) {
  return Json::parse(
      write_flat_json(flatten(loaded.scene, loaded.sources, options), options.links));
}

}  // namespace

TEST_CASE("models are listed once, under unique names") {
  LoadedScene loaded;
  loaded.files.add("other/box.urdf", "<robot name=\"o\"><link name=\"l\"/></robot>");
  loaded.load_text(R"(entities:
- {name: A, file: box.urdf}
- {name: B, file: ./other/../box.urdf}
- {name: C, file: other/box.urdf}
- {name: D, file: crane.smurf}
)");
  CHECK(loaded.briefs() == "");
  const Json flat = to_json(loaded, {});
  CHECK(flat["models"].dump() ==
        R"([{"id":"box","type":"urdf","file":"box.urdf","urdf":"box.urdf"},)"
        R"({"id":"box_2","type":"urdf","file":"other/box.urdf","urdf":"other/box.urdf"},)"
        R"({"id":"crane","type":"smurf","file":"crane.smurf","urdf":"crane.urdf"}])");
  CHECK(flat["instances"][1]["model"] == "box");
  CHECK(flat["instances"][2]["model"] == "box_2");
}

TEST_CASE("files are relative to the folder of the output") {
  LoadedScene loaded;
  loaded.load_text("entities:\n- {name: A, file: box.urdf}\n");
  const auto urdf = [&](const std::string& folder) {
    const FlattenOptions options{.output_folder = folder, .current_folder = "/home/eve/scenes"};
    return to_json(loaded, options)["models"][0]["urdf"].get<std::string>();
  };
  CHECK(urdf(".") == "box.urdf");
  CHECK(urdf("") == "box.urdf");
  CHECK(urdf("out/flat") == "../../box.urdf");
  CHECK(urdf("..") == "scenes/box.urdf");
  CHECK(urdf("/home/eve/out") == "../scenes/box.urdf");
}

TEST_CASE("anchors, parents, joints and properties") {
  LoadedScene loaded;
  loaded.files.add("in.smurfs", "entities:\n- {name: A, file: crane.smurf, pose: up}\n");
  loaded.load_text(R"(entities:
- {name: in, file: in.smurfs, anchor: world}
- name: B
  type: bow
  file: bow.yml
  parent: "A::hook"
  anchor: parent
  main_entity: true
  colors: [red, 1, 1.5, -0x1, "2", ~, yes, .nan, {deep: {er: 1e3}}]
  text: "tab\t quote\" \x01"
)");
  loaded.files.add("bow.yml", "");
  const Json flat = to_json(loaded, {});
  const Json& a = flat["instances"][0];
  const Json& b = flat["instances"][1];
  CHECK(a["anchor"] == "world");
  CHECK(a["parent"] == "world");
  CHECK(a["joint_positions"].dump() == R"({"boom_joint":-0.5})");
  CHECK(b["anchor"].dump() == R"({"instance":"in/A","link":"hook"})");
  CHECK(b["parent"] == b["anchor"]);
  CHECK(b["file"] == "bow.yml");
  CHECK(b["source"].dump() == R"({"file":"scene.smurfs","line":3})");
  CHECK(b["properties"].dump() ==
        "{\"main_entity\":true,\"colors\":[\"red\",1,1.5,\"-0x1\",\"2\",null,\"yes\",\".nan\","
        "{\"deep\":{\"er\":1000}}],\"text\":\"tab\\t quote\\\" \\u0001\"}");
}

TEST_CASE("types that are not known keep all their keys") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: R, type: rainbow, pose: wide, root: true, poses: [{name: wide}], URI: x.yml, a: {b: [1]}}
- {name: B, file: box.urdf, root: true, a: 1}
)");
  const Json flat = to_json(loaded, {});
  CHECK(flat["instances"][0]["properties"].dump() ==
        R"({"pose":"wide","root":true,"poses":[{"name":"wide"}],"URI":"x.yml","a":{"b":[1]}})");
  CHECK(flat["instances"][1]["properties"].dump() == R"({"a":1})");
}

TEST_CASE("the outer scene's world wins, an assembly's does not count") {
  LoadedScene loaded;
  loaded.files.add("in.smurfs", R"(
physics: {gravity: {z: -1}, ode: {cfm: 0.5, stepsize: 3}}
environment: {background: {r: 1, g: 0, b: 0, a: 1}}
lights: [{name: inner}]
)");
  loaded.files.add("as.smurfa", "physics: {ode: {erp: 0.9}}\nlights: [{name: lost}]\n");
  loaded.load_text(R"(
physics: {gravity: {x: 0, y: 0, z: -9.81}}
lights: [{name: outer}]
entities: [{name: in, file: in.smurfs}, {name: as, file: as.smurfa}]
)");
  const Json flat = to_json(loaded, {});
  CHECK(flat["physics"].dump() == R"({"gravity":[0,0,-9.81],"step_size":0.003,"cfm":0.5})");
  CHECK(flat["environment"].dump() == R"({"background":{"r":1,"g":0,"b":0,"a":1}})");
  CHECK(flat["lights"].dump() == R"([{"name":"outer"},{"name":"inner"}])");
}

TEST_CASE("link poses are in the world frame") {
  LoadedScene loaded;
  loaded.load_text("entities:\n- {name: A, file: crane.smurf, position: [5, 0, 0], pose: up}\n");
  const FlatScene flat = flatten(loaded.scene, loaded.sources, {.links = true});
  REQUIRE(flat.instances[0].links.size() == 3);
  const auto& [name, X_WL] = flat.instances[0].links[2];
  CHECK(name == "hook");
  const Matrix expected = translation(5, 0, 1) * rotation_y(-0.5) * translation(2, 0, 0);
  CHECK(difference(to_matrix4(X_WL), expected) < 1e-12);
  CHECK(to_json(loaded, {.links = true})["instances"][0]["links"].size() == 3);
  CHECK(!to_json(loaded, {})["instances"][0].contains("links"));
}

TEST_CASE("a model or a URDF is a scene of one instance") {
  for (const char* path : {"crane.smurf", "crane.urdf"}) {
    LoadedScene loaded;
    loaded.load(path);
    CHECK(loaded.briefs() == "");
    const Json flat = to_json(loaded, {});
    REQUIRE(flat["instances"].size() == 1);
    CHECK(flat["instances"][0]["name"] == "crane");
    CHECK(flat["instances"][0]["source"]["file"] == path);
    CHECK(flat["models"][0]["urdf"] == "crane.urdf");
  }
}

TEST_CASE("a drawing is a scene: hand-computed poses, places in the drawing") {
  LoadedScene loaded;
  loaded.files.add("things/rock.yml", "type: rock_field\ncount: 12\n");
  loaded.files.add("things/box.yml", "name: Box\nfile: ../box.urdf\ntype: urdf\norigin_z: 7\n");
  loaded.files.add("page.svg", R"svg(<?xml version="1.0"?>
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">
<svg xmlns="http://www.w3.org/2000/svg" width="20" height="30">
  <g transform="matrix(0.8,0.6,-0.6,0.8,3,4)">
    <title>things/rock.yml</title>
    <desc>origin_z: 0.5</desc>
    <path d="m 1,2 3,0 0,3 z"/>
  </g>
  <g transform="translate(5, 6)">
    <title> things/box.yml </title>
    <desc>origin_z: -1</desc>
    <path d="m 0,0 1,1"/>
  </g>
  <g transform="matrix(0,-1,1,0,0,0)">
    <g transform="translate(2,1)">
      <title>things/rock.yml</title>
      <desc>the height of the one before stays</desc>
      <path d="M 0,0 1,1"/>
    </g>
  </g>
  <g>
    <title>crane.smurf</title>
    <desc>origin_z: 0</desc>
    <path d="m 20,20"/>
  </g>
</svg>
)svg");
  loaded.load("page.svg");
  CHECK(loaded.briefs() == "SML5012 page.svg:5:12\n"
                           "SML5043 page.svg:14:4\n"
                           "SML5012 page.svg:16:14\n"
                           "SML5040 page.svg:17:13\n"
                           "SML5012 page.svg:22:12\n"
                           "SML5044 page.svg:22:12\n"
                           "SML5044 things/box.yml:3:7\n");
  const Json flat = to_json(loaded, {});
  const auto check = [&](std::size_t i, Vector3 position, double yaw, int line) {
    CAPTURE(i);
    const Json& instance = flat["instances"][i];
    CHECK(instance["source"]["file"] == "page.svg");
    CHECK(instance["source"]["line"] == line);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(std::fabs(instance["position"][k].get<double>() - position[k]) < 1e-12);
    }
    const Json& q = instance["orientation"];
    CHECK(std::fabs(q["w"].get<double>() - std::cos(radians(yaw) / 2)) < 1e-12);
    CHECK(std::fabs(q["z"].get<double>() - std::sin(radians(yaw) / 2)) < 1e-12);
  };
  // x = 3 + 0.8 * 1 - 0.6 * 2; y = 20 - (4 + 0.6 * 1 + 0.8 * 2), from the width.
  check(0, {2.6, 13.8, 0.5}, -36.86989764584402, 4);
  check(1, {5, 14, 7}, 0, 9);
  // A page that turns (x, y) into (y, -x): (2, 1) is drawn at (1, -2).
  check(2, {1, 22, -1}, 90, 15);
  check(3, {20, 0, 0}, 0, 21);
  CHECK(flat["instances"][0]["properties"].dump() ==
        R"({"origin_x":2.5999999999999996,"origin_y":13.8,"origin_z":0.5,)"
        R"("orientation_z":-36.86989764584402,"count":12})");
  CHECK(flat["instances"][0]["type"] == "rock_field");
  CHECK(flat["instances"][0]["file"] == "things/rock.yml");
  CHECK(flat["instances"][1]["name"] == "Box");
  CHECK(flat["models"][0]["file"] == "box.urdf");
}

TEST_CASE("groups of a drawing may share a file, but then they share a name") {
  LoadedScene loaded;
  loaded.files.add("rock.yml", "name: Rock\ntype: rock_field\n");
  loaded.files.add("page.svg", R"svg(<svg width="1">
<g><title>rock.yml</title><desc>origin_z: 0</desc><path d="m 0,0"/></g>
<g><title>rock.yml</title><desc>origin_z: 0</desc><path d="m 1,0"/></g>
<g><title>none.yml</title><desc>origin_z: 0</desc><path d="m 2,0"/></g>
<g><title>none.yml</title><desc>origin_z: 0</desc><path d="m 3,0"/></g>
</svg>)svg");
  loaded.load("page.svg");
  CHECK(loaded.briefs() == "SML5013 page.svg:3:2\nSML5006 page.svg:4:11\n");
  REQUIRE(loaded.scene.instances.size() == 2);
  CHECK(loaded.scene.instances[1].path == "Rock#2");
  CHECK(loaded.scene.instances[1].X_WE->position == Vector3{1, 1, 0});
}

TEST_CASE("MARS leaves models out of drawings, MARS 2 and Phobos read none") {
  LoadedScene loaded;
  loaded.files.add("rock.yml", "type: rock_field\n");
  loaded.files.add("page.svg", R"svg(<svg width="1">
<g><title>rock.yml</title><desc>origin_z: 0</desc><path d="m 0,0"/></g>
<g transform="matrix(0.999624,0.027412,-0.027412,0.999624,0,0)">
<title>box.urdf</title><desc>origin_z: 0</desc><path d="m 0,0"/></g>
</svg>)svg");
  loaded.load("page.svg");
  // Rotated by 1.5708 degrees, which are not radians here.
  CHECK(loaded.briefs() == "SML5012 page.svg:2:11\nSML5012 page.svg:4:8\nSML5044 page.svg:4:8\n");
  const auto loads = [&](std::string_view dialect) {
    std::string text;
    for (const EntityReading& reading : find_dialect(dialect)->read(loaded.scene).entities) {
      text += reading.X_WE ? '1' : '0';
    }
    return text;
  };
  CHECK(loads("spec") == "11");
  CHECK(loads("mars") == "10");
  CHECK(loads("mars2") == "00");
  CHECK(loads("phobos") == "00");
}

TEST_CASE("the steps of an explanation multiply to the pose, in every dialect") {
  for (const char* path :
       {"example/example.smurfs", "nested/outer.smurfs", "showcase/showcase.smurfs"}) {
    for (const Dialect* dialect : dialects()) {
      LoadedScene loaded;
      loaded.load(kScenes + path);
      const SceneReading read = dialect->read(loaded.scene);
      for (std::size_t i = 0; i < loaded.scene.instances.size(); ++i) {
        const Instance& instance = loaded.scene.instances[i];
        CAPTURE(dialect->name);
        CAPTURE(instance.path);
        const auto steps =
            explain(loaded.scene, InstanceIndex{static_cast<std::uint32_t>(i)}, *dialect);
        const std::optional<Pose>& X_WE = read.entities[i].X_WE;
        CHECK(steps.empty() == !X_WE);
        if (steps.empty()) continue;
        Matrix product = translation(0, 0, 0);
        for (const TransformStep& step : steps) {
          product = product * to_matrix4(step.X_step);
          CHECK(difference(product, to_matrix4(step.X_W)) < 1e-12);
          CHECK(!loaded.sources.text(step.span).empty());
        }
        CHECK(difference(product, to_matrix4(*X_WE)) < 1e-12);
      }
    }
  }
}

TEST_CASE("instances are found by path, then by name") {
  LoadedScene loaded;
  loaded.load(kScenes + "nested/outer.smurfs");
  CHECK(find_instance(loaded.scene, "cell/sub/Box") == find_instance(loaded.scene, "Box"));
  CHECK(find_instance(loaded.scene, "Base") == InstanceIndex{0});
  CHECK(!find_instance(loaded.scene, "cell"));
}

TEST_CASE("what has no pose is left out of the text") {
  LoadedScene loaded;
  loaded.load_text("entities:\n- {name: A, file: box.urdf, parent: \"B::lid\"}\n");
  CHECK(loaded.briefs() == "SML5101 scene.smurfs:2:37\n");
  const FlatScene flat = flatten(loaded.scene, loaded.sources, {.links = true});
  REQUIRE(flat.instances.size() == 1);
  CHECK(!flat.instances[0].X_WE);
  CHECK(to_json(loaded, {.links = true})["instances"].empty());
}
