// SPDX-License-Identifier: BSD-3-Clause
// The table of references, also after renaming.
#include "smurf/references.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "smurf/companions.hpp"
#include "smurf/load.hpp"
#include "smurf/rename.hpp"

using namespace smurf;

namespace {

constexpr const char* kUrdf = R"(<robot name="r">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base"><visual name="base_visual"><material name="grey"/></visual></link>
  <link name='arm "1"'>
    <collision name="arm_collision"><geometry><sphere radius="1"/></geometry></collision>
    <sensor name="own"><parent link="base"/></sensor>
  </link>
  <link name="tip"/>
  <joint name="elbow" type="continuous"><parent link="base"/><child link="arm &quot;1&quot;"/></joint>
  <joint name="wrist" type="continuous">
    <parent link="arm &quot;1&quot;"/><child link="tip"/><mimic joint="elbow"/>
  </joint>
  <transmission name="drive"><joint name="elbow"/><actuator name="elbow"/></transmission>
  <gazebo reference="tip"><sensor name="s"><contact><collision>tip_collision_1</collision></contact></sensor></gazebo>
  <gazebo><plugin name="p">
    <jointName>elbow</jointName><topicName>elbow</topicName><frames>base, tip</frames><body>r::tip</body>
    <note>the elbow of base</note>
  </plugin></gazebo>
  <ros2_control name="all"><joint name="wrist"><param name="mimic">elbow</param></joint></ros2_control>
</robot>
)";

constexpr const char* kAnnotations = R"(motors:
- {name: elbow, joint: elbow}
- {name: follower, joint: "wrist", mimic_motor: elbow}
- {name: odd, joint: wrist, mimic_motor: wrist}
sensors:
- {name: positions, type: JointPosition, id: [elbow, wrist]}
- {name: nodes, type: NodePosition, id: [base, arm_collision, base_visual]}
- {name: imu, type: NodeIMU, link: base, links: &links [tip]}
controllers:
- {sensors: [positions], motors: [elbow, 'follower']}
materials:
- {name: grey}
collision:
- {name: arm_collision, link: 'arm "1"'}
visuals:
- {name: base_visual, materialName: grey}
link:
- {name: tip, link: tip, visuals: [], collisions: []}
nodes:
- {name: inertial_tip, mass: 1}
- {name: camera, parent: tip, vizLink: tip}
joint:
- {name: elbow, motor: elbow, joint_dependencies: [{joint: wrist, multiplier: 1}]}
lights:
- {name: lamp, nodeName: camera}
poses:
- name: home
  joints: {elbow: 1, 'wrist': 0}
submechanisms:
- {name: serial, contextual_name: s, jointnames: [elbow, unheard_of],
   loop_constraints: [{cut_joint: wrist, predecessor_body: tip, successor_body: base}], multi_joint_dependencies: [{name: wrist, depends_on: [elbow, {joint: elbow}]}]}
interfaces:
- {name: flange, parent: tip}
submodels:
  half: {start: base, stop: [tip]}
my_own:
  joints: {elbow: {grease: 1}}
  words: elbow
joint_tasks:
- {name: elbow, provider: elbow, port: elbow, driver: elbow}
)";

constexpr const char* kMain = "modelname: r\nfiles: [r.urdf, r_all.yml]\n";

struct OneModel {
  SourceMap sources;
  MemoryFiles files;
  DiagnosticSink sink;
  LinkedModel model;

  explicit OneModel(const std::string& annotations = kAnnotations,
                    const std::string& urdf = kUrdf) {
    files.add("r.smurf", kMain);
    files.add("r.urdf", urdf);
    files.add("r_all.yml", annotations);
    LoadContext context{sources, files, sink, {}, {}};
    model = load_model("r.smurf", context);
  }

  /// "r.urdf:2" for each place that names it.
  std::vector<std::string> places(NameKind kind, std::string_view name) const {
    std::vector<std::string> places;
    for (const Reference& one : references_of(model)) {
      if (one.kind != kind || one.name != name) continue;
      const Position at = sources.position(one.span.source, one.span.begin);
      places.push_back(sources.path(one.span.source) + ":" + std::to_string(at.line));
    }
    return places;
  }
};

Renamed renamed(const OneModel& model, std::initializer_list<Rename> renames) {
  const std::array loaded{references_of(model.model)};
  return rename(loaded, std::vector<Rename>(renames), model.sources);
}

std::string text_of(const Renamed& result, std::string_view path) {
  for (const FixedText& one : result.texts) {
    if (one.path == path) return one.text;
  }
  return {};
}

using Places = std::vector<std::string>;

}  // namespace

TEST_CASE("every place that names a thing is in the table") {
  const OneModel one;
  CHECK(one.places(NameKind::joint, "elbow") ==
        Places{"r_all.yml:2", "r_all.yml:6", "r_all.yml:23", "r_all.yml:30", "r_all.yml:31",
               "r_all.yml:31", "r_all.yml:37", "r_all.yml:40", "r.urdf:9", "r.urdf:11", "r.urdf:13",
               "r.urdf:16", "r.urdf:19"});
  CHECK(one.places(NameKind::motor, "elbow") ==
        Places{"r_all.yml:2", "r_all.yml:3", "r_all.yml:10", "r_all.yml:23", "r_all.yml:28"});
  CHECK(one.places(NameKind::joint, "wrist") ==
        Places{"r_all.yml:3", "r_all.yml:4", "r_all.yml:4", "r_all.yml:6", "r_all.yml:23",
               "r_all.yml:28", "r_all.yml:31", "r_all.yml:31", "r.urdf:10", "r.urdf:19"});
  CHECK(one.places(NameKind::link, "tip") ==
        Places{"r_all.yml:8", "r_all.yml:18", "r_all.yml:18", "r_all.yml:20", "r_all.yml:21",
               "r_all.yml:21", "r_all.yml:31", "r_all.yml:33", "r_all.yml:35", "r.urdf:8",
               "r.urdf:11", "r.urdf:14", "r.urdf:14", "r.urdf:16", "r.urdf:16"});
  CHECK(one.places(NameKind::link, "arm \"1\"") ==
        Places{"r_all.yml:14", "r.urdf:4", "r.urdf:9", "r.urdf:11"});
  CHECK(one.places(NameKind::material, "grey") ==
        Places{"r_all.yml:12", "r_all.yml:16", "r.urdf:2", "r.urdf:3"});
  CHECK(one.places(NameKind::collision, "arm_collision").size() == 3);
  CHECK(one.places(NameKind::visual, "base_visual").size() == 3);
  CHECK(one.places(NameKind::sensor, "positions") == Places{"r_all.yml:6", "r_all.yml:10"});
  CHECK(one.places(NameKind::node, "camera") == Places{"r_all.yml:21", "r_all.yml:25"});
  CHECK(one.places(NameKind::pose, "home") == Places{"r_all.yml:27"});
  CHECK(one.places(NameKind::extension, "drive") == Places{"r.urdf:13"});
}

TEST_CASE("every name is the text at its span") {
  const OneModel one;
  for (const Reference& reference : references_of(one.model)) {
    const std::string text(one.sources.text(reference.span));
    if (text.find('&') == std::string::npos) CHECK(text == reference.name);
  }
}

TEST_CASE("what names nothing, and what names another kind, is doubtful") {
  const OneModel one;
  std::vector<std::string> doubtful;
  for (const Reference& reference : doubtful_references(one.model)) {
    doubtful.push_back(std::string(to_string(reference.kind)) + " " + std::string(reference.name) +
                       (reference.is_known() ? "" : "?") + (reference.is_vague ? "~" : ""));
  }
  CHECK(doubtful == Places{"joint wrist", "collision arm_collision", "visual base_visual",
                           "node camera~", "joint wrist", "joint unheard_of?~"});
}

TEST_CASE("a rename changes the names and nothing else") {
  const OneModel one;
  const Renamed result = renamed(one, {{NameKind::joint, "elbow", "elbow_left"}});
  REQUIRE(result.problems.empty());
  REQUIRE(result.texts.size() == 2);
  const std::string yaml = text_of(result, "r_all.yml");
  CHECK(yaml.find("{name: elbow, joint: elbow_left}") != std::string::npos);
  CHECK(yaml.find("joints: {elbow: 1, 'wrist': 0}") != std::string::npos);  // the motor
  CHECK(yaml.find("joints: {elbow_left: {grease: 1}}") != std::string::npos);
  CHECK(yaml.find("words: elbow\n") != std::string::npos);
  const std::string urdf = text_of(result, "r.urdf");
  CHECK(urdf.find("<jointName>elbow_left</jointName><topicName>elbow</topicName>") !=
        std::string::npos);
  CHECK(urdf.find("<actuator name=\"elbow\"/>") != std::string::npos);

  const OneModel other(yaml, urdf);
  const std::array before{references_of(one.model)};
  const std::array after{references_of(other.model)};
  CHECK(changed_meanings(before, after, other.sources).empty());
  const Renamed back = renamed(other, {{NameKind::joint, "elbow_left", "elbow"}});
  CHECK(text_of(back, "r_all.yml") == kAnnotations);
  CHECK(text_of(back, "r.urdf") == kUrdf);
}

TEST_CASE("a new name is quoted and escaped where it has to be") {
  const OneModel one;
  const Renamed result = renamed(one, {{NameKind::link, "arm \"1\"", "a: \"b\" & 'c'"},
                                       {NameKind::material, "grey", "1: \"x\""},
                                       {NameKind::motor, "follower", "'f'"}});
  REQUIRE(result.problems.empty());
  const std::string yaml = text_of(result, "r_all.yml");
  CHECK(yaml.find(R"(link: 'a: "b" & ''c'''})") != std::string::npos);
  CHECK(yaml.find(R"({name: "1: \"x\""})") != std::string::npos);
  CHECK(yaml.find(R"({name: "'f'", joint: "wrist")") != std::string::npos);
  CHECK(yaml.find(R"(motors: [elbow, '''f'''])") != std::string::npos);
  const std::string urdf = text_of(result, "r.urdf");
  CHECK(urdf.find(R"(<link name='a: "b" &amp; &apos;c&apos;'>)") != std::string::npos);
  CHECK(urdf.find(R"(<child link="a: &quot;b&quot; &amp; 'c'"/>)") != std::string::npos);
  const OneModel other(yaml, urdf);
  const std::array before{references_of(one.model)};
  const std::array after{references_of(other.model)};
  CHECK(changed_meanings(before, after, other.sources).empty());
}

TEST_CASE("renaming a material that is defined in a visual changes no meaning") {
  const OneModel one("", R"(<robot name="r">
  <link name="base">
    <visual><geometry><sphere radius="1"/></geometry><material name="red"><color rgba="1 0 0 1"/></material></visual>
    <visual><geometry><sphere radius="2"/></geometry><material name="blue"><color rgba="0 0 1 1"/></material></visual>
    <visual><geometry><sphere radius="3"/></geometry><material name="blue"/></visual>
  </link>
</robot>
)");
  const Renamed result = renamed(
      one, {{NameKind::material, "red", "dark_red"}, {NameKind::material, "blue", "dark_blue"}});
  REQUIRE(result.problems.empty());
  const OneModel other("", text_of(result, "r.urdf"));
  const std::array before{references_of(one.model)};
  const std::array after{references_of(other.model)};
  CHECK(changed_meanings(before, after, other.sources).empty());
}

TEST_CASE("two things can swap their names") {
  const OneModel one;
  const Renamed result =
      renamed(one, {{NameKind::joint, "elbow", "wrist"}, {NameKind::joint, "wrist", "elbow"}});
  REQUIRE(result.problems.empty());
  CHECK(text_of(result, "r_all.yml").find("id: [wrist, elbow]") != std::string::npos);
}

TEST_CASE("what cannot be renamed is said") {
  const OneModel one;
  const auto problem = [&](const Rename& rename) {
    const Renamed result = renamed(one, {rename});
    CHECK(result.texts.empty());
    return result.problems.empty() ? std::string() : result.problems.front();
  };
  CHECK(problem({NameKind::joint, "elbwo", "x"}) ==
        "there is no joint `elbwo`; did you mean `elbow`?");
  CHECK(problem({{}, "elbow", "x"}) ==
        "`elbow` is a motor and a joint; write motor:elbow or joint:elbow");
  CHECK(problem({{}, "wrist", "elbow"}) == "there is a joint `elbow` already, at r.urdf:9:16");
  CHECK(problem({{}, "wrist", ""}) == "'' is not a name");
  CHECK(renamed(one, {{{}, "wrist", "x"}}).problems.empty());
}

TEST_CASE("one text that names two things is not changed for one of them") {
  const OneModel one("motors:\n- {name: &n wrist, joint: *n}\n");
  const Renamed result = renamed(one, {{NameKind::joint, "wrist", "x"}});
  REQUIRE(result.problems.size() == 1);
  CHECK(result.problems.front().find("also names the motor `wrist`") != std::string::npos);
}

TEST_CASE("a new name that something means already changes meanings") {
  const OneModel one;
  const Renamed result = renamed(one, {{NameKind::joint, "elbow", "unheard_of"}});
  const OneModel other(text_of(result, "r_all.yml"), text_of(result, "r.urdf"));
  const std::array before{references_of(one.model)};
  const std::array after{references_of(other.model)};
  CHECK(changed_meanings(before, after, other.sources) ==
        Places{"r_all.yml:30:63: `unheard_of` would refer to something else than before"});
}

TEST_CASE("names in an SRDF") {
  OneModel one;
  one.files.add("r.srdf", R"(<robot name="r">
  <group name="all"><chain base_link="base" tip_link="tip"/><joint name="elbow"/></group>
  <group name="more"><group name="all"/></group>
  <group_state name="home" group="all"><joint name="elbow" value="0"/></group_state>
  <end_effector name="hand" parent_link="tip" group="all"/>
  <passive_joint name="wrist"/>
  <disable_collisions link1="base" link2="tip" reason="Never"/>
</robot>)");
  LoadContext context{one.sources, one.files, one.sink, {}, {}};
  const Companions companions = load_companions(one.model, context);
  REQUIRE(companions.files.size() == 1);
  std::string found;
  for (const Reference& reference : companion_references(one.model, companions)) {
    found += std::string(to_string(reference.kind)) + " " + std::string(reference.name) + "\n";
  }
  CHECK(found == "group all\nlink base\nlink tip\njoint elbow\ngroup more\ngroup all\ngroup all\n"
                 "joint elbow\nlink tip\ngroup all\njoint wrist\nlink base\nlink tip\n");
}

TEST_CASE("names in a scene") {
  OneModel one;
  one.files.add("world.smurfs", R"(entities:
- {name: first, file: r.smurf, pose: home}
- {name: second, file: r.smurf, parent: "first::tip", anchor: first::tip}
- {name: third, file: r.smurf, poses: [{name: own, joints: {elbow: 1}}], pose: own}
)");
  LoadContext context{one.sources, one.files, one.sink, {}, {}};
  const LinkedScene scene = load_scene("world.smurfs", context);
  const std::array loaded{references_of(scene)};
  std::vector<Rename> renames{{NameKind::link, "tip", "flange"},
                              {NameKind::entity, "first", "carrier"},
                              {NameKind::pose, "home", "start"},
                              {NameKind::motor, "elbow", "elbow_motor"}};
  const Renamed result = rename(loaded, renames, one.sources);
  CHECK(result.problems == Places{});
  CHECK(text_of(result, "world.smurfs") == R"(entities:
- {name: carrier, file: r.smurf, pose: start}
- {name: second, file: r.smurf, parent: "carrier::flange", anchor: carrier::flange}
- {name: third, file: r.smurf, poses: [{name: own, joints: {elbow_motor: 1}}], pose: own}
)");
}
