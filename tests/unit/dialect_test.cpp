// SPDX-License-Identifier: BSD-3-Clause
// Scenes as MARS, MARS 2 and Phobos read them, with numbers computed without our pose code.
#include "smurf/dialect.hpp"

#include <algorithm>
#include <chrono>
#include <doctest/doctest.h>

#include "smurf/flatten.hpp"
#include "support/scenes.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

EntityReading reading(const LoadedScene& loaded, std::string_view dialect,
                      const std::string& path) {
  const std::vector<EntityReading> readings = find_dialect(dialect)->read(loaded.scene).entities;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (loaded.scene.instances[i].path == path) return readings[i];
  }
  FAIL("no instance " << path);
  return {};
}

void check_pose(const LoadedScene& loaded, std::string_view dialect, const std::string& path,
                const Matrix& expected) {
  CAPTURE(dialect);
  CAPTURE(path);
  const EntityReading read = reading(loaded, dialect, path);
  CAPTURE(read.note);
  REQUIRE(read.X_WE);
  CHECK(difference(to_matrix4(*read.X_WE), expected) < 1e-12);
}

Attachment::Kind anchor(const LoadedScene& loaded, std::string_view dialect,
                        const std::string& path) {
  return reading(loaded, dialect, path).anchor.kind;
}

using Kind = Attachment::Kind;

}  // namespace

TEST_CASE("spec is what was loaded") {
  LoadedScene loaded;
  loaded.load(std::string(SMURF_FIXTURES) + "/scenes/nested/outer.smurfs");
  const auto readings = dialects().front()->read(loaded.scene).entities;
  REQUIRE(readings.size() == loaded.scene.instances.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    CHECK(readings[i].X_WE == loaded.scene.instances[i].X_WE);
    CHECK(readings[i].anchor == loaded.scene.instances[i].placement.anchor);
  }
}

TEST_CASE("Phobos takes radians, and quaternions that end with w") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: euler, file: box.urdf, rotation: [0.1, 0.2, 0.3]}
- {name: yaw, file: box.urdf, rotation: 0.5}
- {name: list, file: box.urdf, rotation: [0.5]}
- {name: wxyz, file: box.urdf, rotation: [0.8, 0, 0, 0.6]}
- {name: map, file: box.urdf, rotation: {w: 0.8, x: 0, y: 0, z: 0.6}}
- {name: thing, type: thing, position: [1, 2, 3]}
)");
  check_pose(loaded, "spec", "yaw", rotation_z(radians(0.5)));
  check_pose(loaded, "phobos", "euler", rotation_z(0.3) * rotation_y(0.2) * rotation_x(0.1));
  check_pose(loaded, "phobos", "yaw", rotation_z(0.5));
  check_pose(loaded, "phobos", "wxyz", rotation(0.6, 0.8, 0, 0));
  check_pose(loaded, "phobos", "map", rotation(0.8, 0, 0, 0.6));
  CHECK(reading(loaded, "phobos", "euler").note == "reads the angles as radians");
  CHECK(reading(loaded, "phobos", "wxyz").note == "reads the quaternion as x, y, z, w");
  CHECK(reading(loaded, "phobos", "map").note == "");
  CHECK(!reading(loaded, "phobos", "list").X_WE);
  CHECK(!reading(loaded, "phobos", "thing").X_WE);
}

TEST_CASE("Phobos composes scenes and follows links, with all joints at zero") {
  LoadedScene loaded;
  loaded.files.add("far.yml", "poses:\n- name: far\n  joints: {boom_joint: 3}\n");
  loaded.files.add("far.smurf", "modelname: crane\nfiles: [crane.urdf, far.yml]\n");
  loaded.files.add("in.smurfs", "entities:\n- {name: C, file: box.urdf, rotation: [0, 0, 2]}\n");
  loaded.load_text(R"(entities:
- {name: A, file: far.smurf, pose: far}
- {name: in, file: in.smurfs, parent: "A::hook", position: [1, 0, 0], rotation: [0, 0, 1]}
)");
  const Matrix hook = translation(2, 0, 1);
  check_pose(loaded, "phobos", "in/C", hook * translation(1, 0, 0) * rotation_z(3));
}

TEST_CASE("MARS overwrites parent and anchor inside an include") {
  LoadedScene loaded;
  loaded.files.add("in.smurfs", R"(entities:
- {name: A, file: box.urdf, anchor: world, position: [1, 0, 0]}
- {name: B, file: box.urdf, parent: "A::lid", anchor: parent, position: [0, 0, 1]}
- {name: C, file: box.urdf, parent: none, anchor: world}
)");
  loaded.load_text(
      "entities:\n- {name: in, file: in.smurfs, position: [0, 5, 0], rotation: [90]}\n");
  CHECK(anchor(loaded, "spec", "in/A") == Kind::world);
  CHECK(anchor(loaded, "mars", "in/A") == Kind::none);
  CHECK(anchor(loaded, "mars", "in/B") == Kind::link);
  CHECK(anchor(loaded, "mars", "in/C") == Kind::world);
  CHECK(reading(loaded, "mars", "in/A").note == "loses the anchor");
  const Matrix in = translation(0, 5, 0) * rotation_z(radians(90));
  check_pose(loaded, "mars", "in/A", in * translation(1, 0, 0));
  check_pose(loaded, "mars", "in/B", in * translation(1, 0, 1.1));
  check_pose(loaded, "mars", "in/C", translation(0, 0, 0));  // `none` counts as a parent
  check_pose(loaded, "spec", "in/C", in);
}

TEST_CASE("MARS stretches what stands in an include whose quaternion is no unit") {
  LoadedScene loaded;
  loaded.files.add("in.smurfs", "entities:\n- {name: A, file: box.urdf, position: [1, 0, 0]}\n");
  loaded.load_text("entities:\n- {name: in, file: in.smurfs, rotation: [2, 0, 0, 2]}\n");
  check_pose(loaded, "mars", "in/A", translation(-7, 8, 0) * rotation_z(radians(90)));
  check_pose(loaded, "spec", "in/A", translation(0, 1, 0) * rotation_z(radians(90)));
}

TEST_CASE("MARS creates what it cannot order in file order") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: child, file: box.urdf, parent: "middle::lid", position: [1, 0, 0]}
- {name: middle, file: box.urdf, parent: "base::lid", position: [0, 1, 0]}
- {name: base, file: box.urdf, position: [0, 0, 1]}
- {name: both, file: box.urdf, parent: "base::lid", anchor: parent}
)");
  check_pose(loaded, "spec", "child", translation(1, 1, 1.2));
  check_pose(loaded, "mars", "child", translation(1, 0, 0));
  check_pose(loaded, "mars", "middle", translation(0, 1, 1.1));
  check_pose(loaded, "mars", "both", translation(0, 0, 1.1));
}

TEST_CASE("an entity without name gives MARS the name that absent references have") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: child, file: box.urdf, parent: "middle::lid", position: [1, 0, 0]}
- {name: middle, file: box.urdf, parent: "base::lid", position: [0, 1, 0]}
- {name: base, file: box.urdf, position: [0, 0, 1]}
- {file: box.urdf}
)");
  check_pose(loaded, "mars", "child", translation(1, 1, 1.2));
}

TEST_CASE("names are global in MARS: the first that is created is found") {
  LoadedScene loaded;
  loaded.files.add("in.smurfs", R"(entities:
- {name: A, file: box.urdf}
- {name: B, file: box.urdf, parent: "A::lid", anchor: parent}
)");
  loaded.load_text(R"(entities:
- {name: one, file: in.smurfs, position: [1, 0, 0]}
- {name: two, file: in.smurfs, position: [2, 0, 0]}
)");
  check_pose(loaded, "spec", "two/B", translation(2, 0, 0.1));
  check_pose(loaded, "mars", "two/B", translation(1, 0, 0.1));
}

TEST_CASE("MARS reads poses by motor, and refuses primitives in the wrong notation") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: A, file: crane.smurf, pose: up}
- {name: B, file: box.urdf, parent: "A::hook", anchor: parent}
- {name: list, type: primitive, geometry: {type: box}, position: [1, 0, 0]}
- {name: map, type: primitive, geometry: {type: box}, position: {x: 1, y: 0, z: 0}}
)");
  check_pose(loaded, "mars", "B", translation(2, 0, 1));  // the crane has no motors
  CHECK(!reading(loaded, "mars", "list").X_WE);
  check_pose(loaded, "mars", "map", translation(1, 0, 0));
}

TEST_CASE("Phobos does not apply the pose of an entity") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: A, file: crane.smurf, pose: up, position: [1, 0, 0]}
- {name: B, file: box.urdf, parent: "A::hook"}
)");
  check_pose(loaded, "spec", "B", translation(1, 0, 1) * rotation_y(-0.5) * translation(2, 0, 0));
  check_pose(loaded, "phobos", "B", translation(1, 0, 0) * translation(2, 0, 1));
  CHECK(reading(loaded, "phobos", "A").note == "does not apply `pose`");
  CHECK(reading(loaded, "phobos", "A").joint_pose == JointPoseIndex{});
}

TEST_CASE("MARS leaves out entities of a misspelt type") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: A, type: udrf, file: box.urdf}
- {name: B, type: windmill, file: box.urdf}
)");
  CHECK(!reading(loaded, "mars", "A").X_WE);
  CHECK(reading(loaded, "mars", "A").note == "has no entities of type `udrf`");
  CHECK(reading(loaded, "mars", "B").X_WE);  // a plug-in may have them
}

TEST_CASE("the main file of a model overrides its entity in MARS") {
  LoadedScene loaded;
  loaded.files.add("own.smurf",
                   "modelname: own\nfiles: [box.urdf]\nposition: [0, 0, 7]\nanchor: world\n");
  loaded.load_text("entities:\n- {name: A, file: own.smurf, position: [1, 0, 0]}\n");
  check_pose(loaded, "spec", "A", translation(1, 0, 0));
  check_pose(loaded, "mars", "A", translation(0, 0, 7));
  CHECK(anchor(loaded, "mars", "A") == Kind::world);
}

TEST_CASE("MARS 2 puts everything into the world, fixes what has an anchor, and stops early") {
  LoadedScene loaded;
  loaded.files.add("in.smurfs", "entities:\n- {name: I, file: crane.smurf}\n");
  loaded.load_text(R"(entities:
- {name: A, file: crane.smurf, position: [1, 0, 0], anchor: none}
- {name: B, file: crane.smurf, parent: "A::hook", position: [0, 1, 0], rotation: [90]}
- {name: in, file: in.smurfs}
- {name: stop, file: box.urdf}
- {name: C, file: crane.smurf}
smurfs:
- {name: D, file: crane.smurf}
)");
  check_pose(loaded, "mars2", "B", translation(0, 1, 0) * rotation_z(radians(90)));
  CHECK(anchor(loaded, "mars2", "A") == Kind::world);
  CHECK(anchor(loaded, "mars2", "B") == Kind::none);
  for (const char* path : {"in/I", "stop", "C", "D"}) {
    CAPTURE(path);
    CHECK(!reading(loaded, "mars2", path).X_WE);
    CHECK(!reading(loaded, "mars2", path).note.empty());
  }
}

TEST_CASE("MARS moves old scenes that have a name only") {
  LoadedScene loaded;
  loaded.files.add("old.yml", "nodelist: []\n");
  loaded.load_text(R"(entities:
- {name: A, file: old.yml, position: [1, 0, 0]}
- {file: old.yml, position: [1, 0, 0]}
)");
  check_pose(loaded, "mars", "A", translation(1, 0, 0));
  check_pose(loaded, "mars", "old#1", translation(0, 0, 0));
}

TEST_CASE("what a reader does not load is reported and has no pose") {
  LoadedScene loaded;
  loaded.load_text("entities:\n- {name: A, file: box.urdf}\n");
  DiagnosticSink sink;
  const SceneReading read = read_as(*find_dialect("mars2"), loaded.scene, sink);
  REQUIRE(sink.diagnostics().size() == 1);
  CHECK(sink.diagnostics()[0].rule->name == "not-in-dialect");
  CHECK(!read.entities[0].X_WE);
  const FlatScene flat = flatten(loaded.scene, loaded.sources, {.reading = &read});
  CHECK(!flat.instances[0].X_WE);
  CHECK(loaded.scene.instances[0].X_WE);  // the scene is as it was
}

TEST_CASE("the root link's own anchor counts where the scene says nothing") {
  LoadedScene loaded;
  loaded.files.add("links.yml", "link:\n- {name: base, link: base, anchor: world}\n");
  loaded.files.add("fixed.smurf", "modelname: fixed\nfiles: [box.urdf, links.yml]\n");
  loaded.load_text(R"(entities:
- {name: A, file: fixed.smurf}
- {name: B, file: fixed.smurf, anchor: none}
)");
  CHECK(loaded.at("A").placement.anchor.kind == Kind::world);
  CHECK(loaded.at("B").placement.anchor.kind == Kind::none);
  LoadedScene alone;
  alone.files.add("links.yml", "link:\n- {name: base, link: base, anchor: world}\n");
  alone.files.add("fixed.smurf", "modelname: fixed\nfiles: [box.urdf, links.yml]\n");
  alone.load("fixed.smurf");
  CHECK(alone.at("fixed").placement.anchor.kind == Kind::world);
}

TEST_CASE("chains are read in linear time, whatever their order") {
  LoadedScene loaded;
  constexpr int kCount = 20000;
  std::string text = "entities:\n";
  for (int i = 0; i < kCount; ++i) {
    text += "- {name: e" + std::to_string(i) + ", file: box.urdf, parent: \"e" +
            std::to_string(i + 1) + "::lid\", anchor: parent}\n";
  }
  loaded.files.add("scene.smurfs",
                   text + "- {name: e" + std::to_string(kCount) + ", file: box.urdf}\n");
  LoadContext context{loaded.sources, loaded.files, loaded.sink, loaded.limits, {}};
  loaded.scene = load_scene("scene.smurfs", context);
  for (const Dialect* dialect : dialects()) {
    CAPTURE(dialect->name);
    const auto start = std::chrono::steady_clock::now();
    CHECK(dialect->read(loaded.scene).entities.size() == kCount + 1);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
  }
  const EntityReading last = reading(loaded, "mars", "e0");
  REQUIRE(last.X_WE);
  CHECK(last.X_WE->position[2] == doctest::Approx(0.1 * kCount));
}
