// SPDX-License-Identifier: BSD-3-Clause
// Placement of entities: hand-computed numbers, nesting, parents, names, order and limits.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <doctest/doctest.h>
#include <map>
#include <numeric>
#include <random>

#include "support/scenes.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

const std::string kScenes = std::string(SMURF_FIXTURES) + "/scenes/";

double distance(const Quaternion& a, const Quaternion& b) {
  return std::max(
      {std::fabs(a.w - b.w), std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
}

void check_pose(const LoadedScene& loaded, const std::string& path, const Matrix& expected) {
  CAPTURE(path);
  const Instance& instance = loaded.at(path);
  REQUIRE(instance.X_WE);
  CHECK(difference(to_matrix4(*instance.X_WE), expected) < 1e-12);
  CHECK(instance.X_WE->orientation.w >= 0);
  CHECK(std::fabs(norm(instance.X_WE->orientation) - 1) < 1e-15);
}

/// Decimals as the documentation prints them.
void check_printed(const LoadedScene& loaded, const std::string& path, const Vector3& position,
                   const Quaternion& orientation) {
  CAPTURE(path);
  const Instance& instance = loaded.at(path);
  REQUIRE(instance.X_WE);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::fabs(instance.X_WE->position[i] - position[i]) < 1e-9);
  }
  CHECK(distance(instance.X_WE->orientation, orientation) < 1e-9);
}

}  // namespace

TEST_CASE("the documented scene has its documented poses") {
  LoadedScene loaded;
  loaded.load(kScenes + "example/example.smurfs");
  CHECK(loaded.briefs() == "");
  check_printed(loaded, "Eve", {5, 0, -0.8}, {0.984723382, 0.012890735, 0.173633301, -0.002272984});
  check_printed(loaded, "Adam", {-2, 3.5, 0}, {0.707106781, 0, -0.707106781, 0});
  check_printed(loaded, "Lazy Bob", {0, 0, 0}, {0.991444861, 0, 0, 0.130526192});
  check_pose(loaded, "Eve",
             translation(5, 0, -0.8) * rotation_y(radians(20)) * rotation_x(radians(1.5)));
  check_pose(loaded, "Adam", translation(-2, 3.5, 0) * rotation(0.7071, 0, -0.7071, 0));
  check_pose(loaded, "Lazy Bob", rotation_z(radians(15)));
  check_pose(loaded, "rainbow1", translation(1500, 300, 270) * rotation_z(radians(37.5)));
  CHECK(loaded.at("Lazy Bob").placement.anchor.kind == Attachment::Kind::world);
  CHECK(loaded.scene.joint_positions(loaded.at("Lazy Bob")) ==
        JointPositions{{"shoulder", std::acos(-1.0) / 4}});
  CHECK(loaded.scene.models.size() == 2);
}

TEST_CASE("nested scenes hang on the posed link that their include names") {
  LoadedScene loaded;
  loaded.load(kScenes + "nested/outer.smurfs");
  REQUIRE(loaded.diagnostics.size() == 1);
  CHECK(loaded.diagnostics[0].rule->name == "nested-anchor-lost");
  check_printed(loaded, "Base", {1, 2, 0.5}, {0.707106781, 0, 0, 0.707106781});
  check_printed(loaded, "cell/Table", {0, 2.446918132, 0.883746297},
                {0.250772988, -0.064032856, -0.238973874, -0.935897532});
  check_printed(loaded, "cell/Cup", {0.05, 2.730486407, 1.583452688},
                {0.222601347, 0.132045213, -0.830759538, -0.492799444});
  check_printed(loaded, "cell/Lamp", {1, 3.405769210, 2.638911421},
                {0, 0, 0.247403959, 0.968912422});
  check_printed(loaded, "cell/sub/Box", {0, 1.569335571, 1.363171836},
                {0.174941017, 0.685124544, -0.174941017, -0.685124544});

  const Matrix base = translation(1, 2, 0.5) * rotation_z(radians(90));
  const Matrix flange = base * translation(0, 0, 0.4) * rotation_y(0.5) * translation(0.3, 0, 0);
  const Matrix cell = flange * translation(0.1, 0, 0.2) * rotation_z(radians(90));
  const Matrix table = cell * translation(1, 0, 0) * rotation_z(radians(30));
  check_pose(loaded, "Base", base);
  check_pose(loaded, "cell/Table", table);
  check_pose(loaded, "cell/Cup",
             table * translation(0, 0, 0.7) * translation(0, 0.1, 0.05) *
                 rotation(0.7071068, 0.7071068, 0, 0));
  check_pose(loaded, "cell/Lamp", cell * translation(0, 0, 2));
  check_pose(loaded, "cell/sub/Box",
             cell * translation(0, 1, 0) * rotation_y(radians(90)) * translation(0, 0, 1));
  CHECK(loaded.at("cell/Table").placement.anchor.link == "flange");
  CHECK(loaded.at("cell/Lamp").placement.anchor.kind == Attachment::Kind::world);
}

TEST_CASE("one entity of every kind loads; only that of Phobos needs a plug-in") {
  LoadedScene loaded;
  loaded.load(kScenes + "showcase/showcase.smurfs");
  // The arm is used twice, and its mimicking finger names the leader.
  REQUIRE(loaded.diagnostics.size() == 2);
  CHECK(loaded.diagnostics[0].rule->id == "SML3115");
  CHECK(loaded.diagnostics[1].rule->id == "SML5019");
  CHECK(loaded.scene.instances.size() == 5);
  CHECK(loaded.at("Hill").type == "heightmap");
  for (const Instance& instance : loaded.scene.instances) CHECK(instance.X_WE);
}

TEST_CASE("a rotation of one, three and four numbers, as list, number or mapping") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: a, file: box.urdf, rotation: 30}
- {name: b, file: box.urdf, rotation: [30]}
- {name: c, file: box.urdf, rotation: [10, 20, 30]}
- {name: d, file: box.urdf, rotation: [0.8, 0.6, 0, 0], position: {x: 1, z: 3}}
- {name: e, file: box.urdf, rotation: {x: 0.6, w: 0.8, y: 0, z: 0}}
- {name: f, file: box.urdf, rotation: [-1, 0, 0, 0]}
)");
  CHECK(loaded.briefs() == "");
  check_pose(loaded, "a", rotation_z(radians(30)));
  check_pose(loaded, "b", rotation_z(radians(30)));
  check_pose(loaded, "c",
             rotation_z(radians(30)) * rotation_y(radians(20)) * rotation_x(radians(10)));
  check_pose(loaded, "d", translation(1, 0, 3) * rotation(0.8, 0.6, 0, 0));
  check_pose(loaded, "e", rotation(0.8, 0.6, 0, 0));
  check_pose(loaded, "f", translation(0, 0, 0));
}

TEST_CASE("poses do not depend on the order of the entities") {
  std::vector<std::string> lines = {
      R"({name: A, file: crane.smurf, position: [1, 2, 3], rotation: [0, 0, 40], pose: up})",
      R"({name: B, file: crane.smurf, parent: "A::hook", anchor: parent, rotation: [5, 6, 7]})",
      R"({name: C, file: box.urdf, parent: "B::boom", position: [0.1, 0, 0], anchor: parent})",
      R"({name: D, file: box.urdf, parent: "C::lid", anchor: parent, rotation: [90]})",
      R"({name: E, file: box.urdf, anchor: "D::lid", position: [9, 9, 9]})"};
  std::map<std::string, Pose> reference;
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), 0U);
  do {
    LoadedScene loaded;
    std::string text = "entities:\n";
    for (const std::size_t i : order) text += "- " + lines[i] + "\n";
    loaded.load_text(text);
    REQUIRE(loaded.scene.instances.size() == lines.size());
    for (const Instance& instance : loaded.scene.instances) {
      REQUIRE(instance.X_WE);
      const auto [known, is_new] = reference.emplace(instance.path, *instance.X_WE);
      CHECK(known->second == *instance.X_WE);  // to the last bit
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("names mean the innermost entity, then those around it, then any") {
  LoadedScene loaded;
  loaded.files.add("pair.smurfs", R"(entities:
- {name: Table, file: box.urdf}
- {name: Cup, file: box.urdf, parent: "Table::lid", anchor: parent}
- {name: Lamp, file: box.urdf, parent: "Pole::lid", anchor: parent}
)");
  loaded.load_text(R"(entities:
- {name: left, file: pair.smurfs}
- {name: right, file: pair.smurfs, position: [10, 0, 0]}
- {name: Pole, file: box.urdf, position: [0, 5, 0]}
- {name: Fly, file: box.urdf, parent: "Cup::lid", anchor: parent}
)");
  // In the second copy, MARS uses another cup; for the fly, the choice of a cup is a guess, as in
  // MARS.
  CHECK(loaded.briefs() == "SML5014 pair.smurfs:3:39\nSML5014 scene.smurfs:5:39\n");
  check_pose(loaded, "left/Cup", translation(0, 0, 0.1));
  check_pose(loaded, "right/Cup", translation(10, 0, 0.1));
  check_pose(loaded, "right/Lamp", translation(0, 5, 0.1));
  check_pose(loaded, "Fly", translation(0, 0, 0.2));
  CHECK(loaded.scene.scenes.size() == 2);
  CHECK(loaded.scene.models.size() == 1);
  CHECK(loaded.sources.size() == 3);
}

TEST_CASE("what an include gives to the entities inside") {
  LoadedScene loaded;
  loaded.files.add("inner.smurfs", R"(entities:
- {name: plain, file: box.urdf}
- {name: free, file: box.urdf, anchor: none}
- {name: own, file: box.urdf, parent: "Base::hook", anchor: none}
)");
  loaded.files.add("tool.smurfa", R"(smurfa:
- {name: root, file: box.urdf, root: true}
- {name: member, file: box.urdf, position: [0, 0, 1]}
)");
  loaded.load_text(R"(entities:
- {name: Base, file: crane.smurf}
- {name: in, file: inner.smurfs, parent: "Base::hook", position: [1, 0, 0], anchor: parent}
- {name: as, file: tool.smurfa, parent: "Base::hook", position: [1, 0, 0], anchor: world}
)");
  const auto anchor = [&](const std::string& path) { return loaded.at(path).placement.anchor; };
  CHECK(anchor("in/plain").link == "hook");
  CHECK(anchor("in/free").kind == Attachment::Kind::none);
  CHECK(anchor("in/own").kind == Attachment::Kind::none);
  CHECK(anchor("as/root").kind == Attachment::Kind::world);
  CHECK(anchor("as/member").kind == Attachment::Kind::none);
  check_pose(loaded, "in/plain", translation(3, 0, 1));
  check_pose(loaded, "in/own", translation(2, 0, 1));
  check_pose(loaded, "as/root", translation(3, 0, 1));
  check_pose(loaded, "as/member", translation(3, 0, 2));
  CHECK(loaded.briefs() == "SML5201 inner.smurfs:3:40\nSML5204 tool.smurfa:3:10\n");
}

TEST_CASE("joint pose sets of the entity come before those of the model") {
  LoadedScene loaded;
  loaded.load_text(R"(entities:
- {name: A, file: crane.smurf, pose: up, poses: [{name: up, joints: {boom_joint: 0.25}}]}
- {name: B, file: crane.smurf, pose: default}
)");
  CHECK(loaded.scene.joint_positions(loaded.at("A")) == JointPositions{{"boom_joint", 0.25}});
  REQUIRE(loaded.diagnostics.size() == 1);
  CHECK(loaded.diagnostics[0].rule->name == "unknown-pose");
  CHECK(loaded.diagnostics[0].severity == Severity::info);  // Phobos 0.7 writes it always
}

TEST_CASE("one cause, one finding") {
  const auto findings = [](const std::string& entities) {
    LoadedScene loaded;
    loaded.load_text("entities:\n" + entities);
    return loaded.briefs();
  };
  // Consequences of a broken entity are not reported.
  CHECK(findings("- {name: A, file: nowhere.urdf}\n"
                 "- {name: B, file: box.urdf, parent: \"A::lid\", anchor: parent}\n") ==
        "SML5006 scene.smurfs:2:19\n");
  CHECK(findings("- {name: A, file: box.urdf, parent: \"A::lid\", anchor: parent}\n"
                 "- {name: B, file: box.urdf, parent: \"A::lid\", anchor: parent}\n") ==
        "SML5104 scene.smurfs:2:37\n");
  CHECK(findings("- {name: A, file: nowhere.smurfs}\n"
                 "- {name: B, file: box.urdf, parent: \"C::lid\", anchor: parent}\n") ==
        "SML5006 scene.smurfs:2:19\n");
  CHECK(findings("- {name: A, file: box.urdf, position: [1, 2]}\n"
                 "- {name: B, file: box.urdf, parent: \"A::lid\", anchor: parent}\n") ==
        "SML4001 scene.smurfs:2:39\n");
  CHECK(findings("- {name: A, file: crane.smurf}\n"
                 "- {name: B, file: box.urdf, parent: \"A::boom_hull\", anchor: parent}\n") ==
        "SML5101 scene.smurfs:3:37\n");
}

TEST_CASE("findings say what to do") {
  const auto help = [](const std::string& key) {
    LoadedScene loaded;
    loaded.load_text("entities:\n- {name: Base, file: crane.smurf}\n"
                     "- {name: B, file: box.urdf, " +
                     key + "}\n");
    REQUIRE(loaded.diagnostics.size() == 1);
    return loaded.diagnostics[0].help_text;
  };
  CHECK(help("parent: Base") == "write `Base::foot`");
  CHECK(help("parent: Bass") == "did you mean `Base::foot`?");
  CHECK(help("parent: \"Bass::hook\"") == "did you mean `Base::hook`?");
  CHECK(help("parent: \"Base::hok\"") == "did you mean `Base::hook`?");
  CHECK(help("parent: \"Base::boom_hull\"") == "name its link: `Base::boom`");
  CHECK(help("anchor: wrld") == "did you mean `world`?");
  CHECK(help("anchor: false") == "write `none`; MARS fixes the entity to the world");
}

TEST_CASE("includes that never end are refused") {
  LoadedScene loaded;
  loaded.files.add("a.smurfs", "entities:\n- {name: b, file: ./sub/../b.smurfs}\n");
  loaded.files.add("b.smurfs", "entities:\n- {name: scene, file: scene.smurfs}\n");
  loaded.load_text("entities:\n- {name: a, file: a.smurfs}\n");
  CHECK(loaded.briefs() == "SML5020 b.smurfs:2:23\n");
  CHECK(loaded.diagnostics[0].notes ==
        std::vector<std::string>{"`scene.smurfs` includes `a.smurfs` includes `b.smurfs` includes "
                                 "`scene.smurfs`"});
}

TEST_CASE("nesting and size have limits") {
  LoadedScene deep;
  deep.limits.include_depth = 3;
  for (int i = 0; i < 6; ++i) {
    deep.files.add("s" + std::to_string(i) + ".smurfs",
                   "entities:\n- {name: n, file: s" + std::to_string(i + 1) + ".smurfs}\n");
  }
  deep.load("s0.smurfs");
  CHECK(deep.briefs() == "SML5021 s3.smurfs:2:19\n");

  // Ten files that each include the next one ten times.
  LoadedScene wide;
  wide.limits.instances = 1000;
  for (int i = 0; i < 10; ++i) {
    std::string text = "entities:\n";
    for (int k = 0; k < 10; ++k) {
      text += "- {name: n" + std::to_string(k) + ", file: w" + std::to_string(i + 1) + ".smurfs}\n";
    }
    wide.files.add("w" + std::to_string(i) + ".smurfs", text);
  }
  wide.files.add("w10.smurfs", "entities:\n- {name: n, file: box.urdf}\n");
  wide.load("w0.smurfs");
  REQUIRE(wide.diagnostics.size() == 1);
  CHECK(wide.diagnostics[0].rule->name == "too-many-instances");
  CHECK(!wide.scene.is_complete);
}

TEST_CASE("paths are unique whatever the names are") {
  LoadedScene loaded;
  loaded.files.add("inner.smurfs", "entities:\n- {name: b, file: box.urdf}\n");
  loaded.load_text(R"(entities:
- {name: a/b, file: box.urdf}
- {name: a, file: inner.smurfs}
- {name: a, file: inner.smurfs}
- {file: box.urdf}
- {file: box.urdf}
- {name: a/b, file: box.urdf}
)");
  std::vector<std::string> paths;
  for (const Instance& instance : loaded.scene.instances) paths.push_back(instance.path);
  CHECK(paths == std::vector<std::string>{"a/b", "a/b#2", "a#2/b", "box#1", "box#2", "a/b#3"});
}

TEST_CASE("long chains and large scenes take linear time") {
  LoadedScene loaded;
  constexpr int kCount = 10000;
  std::string text = "entities:\n- {name: n0, file: box.urdf}\n";
  // Each entity is placed on the lid of the next one: the longest chain, in the worst order.
  for (int i = 1; i < kCount; ++i) {
    text.insert(10, "- {name: n" + std::to_string(i) + ", file: box.urdf, parent: \"n" +
                        std::to_string(i - 1) + "::lid\", anchor: parent}\n");
  }
  const auto begin = std::chrono::steady_clock::now();
  loaded.load_text(text);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  CHECK(loaded.briefs() == "");
  CHECK(std::fabs(loaded.at("n9999").X_WE->position[2] - 999.9) < 1e-8);
  CHECK(seconds.count() < 20);  // a quadratic look-up takes minutes with sanitizers
}

TEST_CASE("nothing but garbage is refused without a crash") {
  for (const std::string text :
       {"", "[]", "entities:", "entities: [1, [2], null]", "entities:\n- {}\n",
        "entities:\n- {name: [a], file: {b: c}, parent: [], rotation: {}}\n",
        "physics: 3\nenvironment: []\nlights: {}\nplugins: x\n",
        "smurfs:\n- {name: a, file: box.urdf}\nentities:\n- {name: b, type: '', file: box}\n"}) {
    LoadedScene loaded;
    CAPTURE(text);
    loaded.load_text(text);
    for (const Diagnostic& diagnostic : loaded.diagnostics) CHECK(!diagnostic.message.empty());
  }
}
