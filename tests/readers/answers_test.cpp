// SPDX-License-Identifier: BSD-3-Clause
// The printed verdicts of targets on a robot with a changed value, name or element.
#include <doctest/doctest.h>

#include <memory>

#include "readers/answers.hpp"
#include "support/loaded.hpp"

using namespace smurf;

TEST_CASE("a slip in a name that readers need is judged as what is missing") {
  using enum Answer;
  struct Slip {
    const char* original;
    const char* text;
    Answer ros, gazebo, mujoco;  // the answers of the programs
  };
  constexpr Slip kSlips[] = {
      {"", "", loses, takes, takes},  // KDL computes without the mass of the root
      {"effort=", "efrot=", refuses, refuses, loses},
      {"velocity=", "velocty=", refuses, refuses, loses},
      {"<limit ", "<limt ", refuses, refuses, loses},
      {"<limit ", "<Limit ", refuses, refuses, loses},
      {"<parent link=\"base\"/>", "<parnet link=\"base\"/>", refuses, refuses, refuses},
      {"<parent link=", "<parent lnik=", refuses, refuses, refuses},
      {"<child link=\"arm\"/>", "<chid link=\"arm\"/>", refuses, refuses, refuses},
      {"<child link=\"arm\"/>", "<Child link=\"arm\"/>", refuses, refuses, refuses},
      {"joint name=", "joint Name=", refuses, refuses, refuses},
      {"<robot name=", "<robot nmae=", refuses, refuses, loses},
      {"mass value=", "mass vlaue=", loses, loses, refuses},
      {"<mass value=\"1\"/>", "<mas value=\"1\"/>", loses, loses, refuses},
      {"sphere radius=", "sphere raduis=", loses, loses, refuses},
      {"<box size=\"1 1 1\"/>", "<bxo size=\"1 1 1\"/>", loses, loses, refuses},
      {"<box size=\"1 1 1\"/>", "<thing/>", loses, loses, refuses},
      {"axis xyz=", "axis xzy=", loses, refuses, refuses},
  };
  for (const Slip& slip : kSlips) {
    CAPTURE(slip.text);
    CHECK(to_string(answer_for("ros", slip.original, slip.text)) == to_string(slip.ros));
    CHECK(to_string(answer_for("gazebo", slip.original, slip.text)) == to_string(slip.gazebo));
    CHECK(to_string(answer_for("mujoco", slip.original, slip.text)) == to_string(slip.mujoco));
  }
}

TEST_CASE("the name of a joint does not change what a reader makes of its pose") {
  for (const char* name : {"elbow", "rotation", "position", "physics", "links"}) {
    CAPTURE(name);
    std::string robot(kRobot);
    robot.replace(robot.find("joint name=\"a\""), 14, "joint name=\"" + std::string(name) + "\"");
    test::Loaded loaded;
    loaded.files.add("r.urdf", robot);
    loaded.files.add("r.smurf", "modelname: r\nfiles: [r.urdf, r.yml]\n");
    loaded.files.add("r.yml", "poses: [{name: p, joints: {" + std::string(name) + ": abc}}]\n");
    loaded.load("r.smurf");
    const std::vector<std::string> found = loaded.briefs();
    CHECK(std::any_of(found.begin(), found.end(),
                      [](const std::string& one) { return one.starts_with("SML4001"); }));
    CHECK(judge_target(*find_target("phobos"), loaded.diagnostics).answer() == Answer::takes);
    CHECK(judge_target(*find_target("mars"), loaded.diagnostics).answer() == Answer::takes);
  }
}

TEST_CASE("a robot of URDF 1.2 loads in the release that knows it, and needs its version") {
  const auto load = [](const std::string& version, const std::string& limit,
                       const std::string& shape) {
    std::string robot(kRobot);
    const auto replace = [&](std::string_view old_text, const std::string& new_text) {
      robot.replace(robot.find(old_text), old_text.size(), new_text);
    };
    replace("<robot name=\"r\"", "<robot name=\"r\" version=\"" + version + "\"");
    replace("effort=\"1\"", "effort=\"1\"" + limit);
    replace("<sphere radius=\"1\"/>", shape);
    auto loaded = std::make_unique<test::Loaded>();
    loaded->files.add("r.urdf", robot);
    loaded->load("r.urdf");
    return loaded;
  };
  const std::string sphere = "<sphere radius=\"1\"/>";
  const std::string capsule = "<capsule radius=\"1\" length=\"1\"/>";
  const auto answer = [](const char* target, const test::Loaded& loaded) {
    return judge_target(*find_target(target), loaded.diagnostics).answer();
  };
  const auto robot = load("1.2", " jerk=\"1\"", capsule);
  CHECK(answer("ros:jazzy", *robot) == Answer::refuses);
  CHECK(answer("ros:rolling", *robot) == Answer::takes);
  CHECK(answer("ros", *robot) == Answer::refuses);
  CHECK(answer("ros:rolling", *load("1.0", "", capsule)) == Answer::loses);
  const auto fixes = [](const test::Loaded& loaded) {
    REQUIRE(!loaded.diagnostics.empty());
    REQUIRE(loaded.diagnostics[0].rule->id == "SML1104");
    return loaded.diagnostics[0].fixes.size();
  };
  CHECK(fixes(*load("1.2", "", sphere)) == 1);
  CHECK(fixes(*load("1.2", " jerk=\"1\"", sphere)) == 0);  // its meaning would be lost
  CHECK(fixes(*load("1.1", "", capsule)) == 0);
  CHECK(fixes(*load("3.0", "", capsule)) == 1);
}

TEST_CASE("MuJoCo is judged by the hexadecimal numbers and infinities it reads") {
  CHECK(answer_for("mujoco", "ixx=\"1\"", "ixx=\"0x1\"") == Answer::loses);
  CHECK(answer_for("mujoco", "ixx=\"1\"", "ixx=\"0x5\"") == Answer::refuses);
  CHECK(answer_for("mujoco", "ixy=\"0\"", "ixy=\" 0x1p1\"") == Answer::refuses);
  CHECK(answer_for("gazebo", "ixx=\"1\"", "ixx=\"0x5\"") == Answer::loses);
  CHECK(answer_for("mujoco", "radius=\"1\"", "radius=\"0x1\"") == Answer::loses);
  for (const char* radius : {"-inf", "0x0", "-0x1"}) {
    CAPTURE(radius);
    const std::string text = "radius=\"" + std::string(radius) + "\"";
    CHECK(answer_for("mujoco", "radius=\"1\"", text) == Answer::refuses);
  }
}

TEST_CASE("MuJoCo needs the name of a visual's material without a colour") {
  const auto answer_with = [](const std::string& material) {
    const std::string visual =
        "<visual><geometry><box size=\"1 1 1\"/></geometry>" + material + "</visual><collision>";
    return answer_for("mujoco", "<collision>", visual);
  };
  CHECK(answer_with("<material/>") == Answer::refuses);
  CHECK(answer_with("<material nmae=\"red\"/>") == Answer::refuses);
  CHECK(answer_with("<material><color rgba=\"1 0 0 1\"/></material>") == Answer::takes);
  CHECK(answer_for("mujoco", "</robot>", "<material/></robot>") == Answer::takes);
}

TEST_CASE("MuJoCo looks for meshes where the file tells it") {
  const auto answer_with = [](const std::string& compiler, const std::string& mesh) {
    std::string robot = damaged("<sphere radius=\"1\"/>", "<mesh filename=\"" + mesh + "\"/>");
    robot.insert(robot.rfind("</robot>"), "<mujoco><compiler " + compiler + "/></mujoco>");
    constexpr const char* kMeshes[] = {"there.obj", "folder/inner.obj"};
    return answer_to("mujoco", robot, kMeshes);
  };
  CHECK(answer_with("", "there.obj") == Answer::takes);
  CHECK(answer_with("meshdir=\"\"", "there.obj") == Answer::takes);
  CHECK(answer_with("meshdir=\"gone\"", "there.obj") == Answer::refuses);
  CHECK(answer_with("assetdir=\"gone\"", "there.obj") == Answer::refuses);
  CHECK(answer_with("meshdir=\"folder\" assetdir=\"gone\"", "inner.obj") == Answer::takes);
  CHECK(answer_with("", "package://r/there.obj") != Answer::takes);
  CHECK(answer_with("strippath=\"true\"", "folder/inner.obj") == Answer::refuses);
  CHECK(answer_with("strippath=\"true\" meshdir=\"folder\"", "gone/inner.obj") == Answer::takes);
}

TEST_CASE("sdformat looks at the inertia of a link whose fixed joint it is told to keep") {
  const auto answer_with = [](const std::string& flag) {
    std::string robot = damaged("revolute", "fixed");
    robot.replace(robot.rfind("ixx=\"1\""), 7, "ixx=\"2.5\"");
    robot.insert(robot.rfind("</robot>"), "<gazebo reference=\"a\">" + flag + "</gazebo>");
    return answer_to("gazebo", robot);
  };
  CHECK(answer_with("") == Answer::takes);
  CHECK(answer_with("<preserveFixedJoint>false</preserveFixedJoint>") == Answer::takes);
  CHECK(answer_with("<preserveFixedJoint>Yes</preserveFixedJoint>") == Answer::refuses);
  CHECK(answer_with("<preserveFixedJoint value=\"1\"/>") == Answer::refuses);
  CHECK(answer_with("<disableFixedJointLumping>true</disableFixedJointLumping>") ==
        Answer::refuses);
}

TEST_CASE("what stands in an inertial matters where the body moves by itself, or is the root") {
  const auto carried = [](const char* target, std::string_view text) {
    std::string robot = damaged("revolute", "fixed");
    return answer_to(target, robot.replace(robot.rfind("ixx=\"1\""), 7, text));
  };
  CHECK(answer_for("mujoco", "ixx=\"1\"", "ixx=\"inf\"") == Answer::refuses);
  CHECK(carried("mujoco", "ixx=\"inf\"") == Answer::loses);
  CHECK(answer_for("gazebo", "mass value=\"1\"", "mass value=\"1 2\"") == Answer::refuses);
  CHECK(answer_for("gazebo", "<mass value=\"1\"/>", "") == Answer::refuses);
  CHECK(carried("gazebo", "ixx=\"1 2\"") == Answer::loses);
  const auto with_0 = [](std::string_view target) {
    return answer_for(target, "iyy=\"1\" iyz=\"0\" izz=\"1\"",
                      "iyy=\"2\" iyz=\"0\" izz=\"1e-400\"");
  };
  CHECK(with_0("gazebo") == Answer::refuses);
  CHECK(with_0("ros") == Answer::loses);
  const std::string heavy = "<origin xyz=\"0 0 1\"/><mass value=\"1e30\"/>";
  CHECK(answer_for("gazebo", "<mass value=\"1\"/>", heavy) == Answer::takes);
  CHECK(answer_to("gazebo", [&] {
          std::string robot = damaged("revolute", "fixed");
          return robot.replace(robot.rfind("<mass value=\"1\"/>"), 17, heavy);
        }()) == Answer::unknown);
}

TEST_CASE("readers do not look at all parts of a joint of every type") {
  const auto fixed = [](const char* target, std::string_view original, std::string_view text) {
    std::string robot = damaged(original, text);
    return answer_to(target, robot.replace(robot.find("revolute"), 8, "fixed"));
  };
  CHECK(answer_for("mujoco", "effort=\"1\"", "effort=\"foo\"") == Answer::refuses);
  CHECK(fixed("mujoco", "effort=\"1\"", "effort=\"foo\"") == Answer::takes);
  CHECK(fixed("ros", "effort=\"1\"", "effort=\"foo\"") == Answer::refuses);
  CHECK(answer_for("gazebo", "xyz=\"0 0 1\"", "xyz=\"foo\"") == Answer::refuses);
  CHECK(fixed("gazebo", "xyz=\"0 0 1\"", "xyz=\"foo\"") == Answer::takes);
  CHECK(fixed("mujoco", "xyz=\"0 0 1\"", "xyz=\"foo\"") == Answer::refuses);
}

TEST_CASE("MoveIt normalises the axis of a revolute joint, but not of a prismatic one") {
  std::string turning = damaged("xyz=\"0 0 1\"", "xyz=\"0 0 2\"");
  const std::size_t root_inertial = turning.find("  <inertial>");  // KDL ignores it
  turning.erase(root_inertial, turning.find("  <collision>") - root_inertial);
  CHECK(answer_to("ros", turning) == Answer::takes);
  std::string sliding = turning;
  CHECK(answer_to("ros", sliding.replace(sliding.find("revolute"), 8, "prismatic")) ==
        Answer::loses);
}

TEST_CASE("a joint that moves the link `world` is refused, and a robot that is the world is none") {
  CHECK(answer_for("gazebo", "\"arm\"", "\"world\"") == Answer::refuses);
  CHECK(answer_for("mujoco", "\"arm\"", "\"world\"") == Answer::refuses);
  const std::string world = "<robot name=\"r\"><link name=\"world\"/></robot>";
  CHECK(answer_to("gazebo", world) == Answer::refuses);
  CHECK(answer_to("mujoco", world) != Answer::refuses);
}

TEST_CASE("sdformat refuses a joint without a name that stays a joint") {
  CHECK(answer_for("gazebo", "joint name=\"a\"", "joint name=\"\"") == Answer::refuses);
  CHECK(answer_for("gazebo", "joint name=\"a\" type=\"revolute\"",
                   "joint name=\"\" type=\"fixed\"") == Answer::takes);
  CHECK(answer_for("gazebo", "joint name=\"a\"", "joint name=\" \"") == Answer::refuses);
  CHECK(answer_for("gazebo", "joint name=\"a\" type=\"revolute\"",
                   "joint name=\" \" type=\"fixed\"") != Answer::refuses);
  CHECK(answer_for("gazebo", "robot name=\"r\"", "robot name=\" \"") == Answer::refuses);
  CHECK(answer_for("dart", "robot name=\"r\"", "robot name=\" \"") == Answer::takes);
}

TEST_CASE("a file with elements of xacro is read and judged without them") {
  CHECK(answer_for("ros", "<joint name", "<xacro:x/><joint name") == Answer::loses);
  CHECK(answer_for("ros", "<link name=\"arm\">", "<xacro:x/><link>") == Answer::refuses);
  CHECK(answer_for("mujoco", "mass value=\"1\"", "xacro:x/><mass value=\"-1\"") == Answer::refuses);
  CHECK(answer_for("ros", "effort=\"1\"", "effort=\"${e}\"") == Answer::refuses);
  CHECK(answer_for("mujoco", "effort=\"1\"", "effort=\"${e}\"") == Answer::refuses);
}

TEST_CASE("a joint of Drake's is one to Drake") {
  constexpr std::string_view kStandard = "<joint name=\"a\" type=\"revolute\">";
  constexpr std::string_view kBall = "<drake:joint name=\"a\" type=\"ball\">";
  std::string robot(kRobot);
  robot.replace(robot.find(kStandard), kStandard.size(), kBall);
  robot.replace(robot.find("</joint>"), 8, "</drake:joint>");
  const auto count = [&](std::string_view target, std::string_view rule) {
    MemoryFiles files;
    files.add("robot.urdf", robot);
    CheckSettings settings;
    if (!target.empty()) settings.selection.targets.push_back(find_target(target));
    Session session(files);
    const std::vector<Diagnostic> found = session.check("robot.urdf", settings).diagnostics;
    return std::ranges::count_if(found,
                                 [&](const Diagnostic& one) { return one.rule->id == rule; });
  };
  CHECK(count("drake", "SML1204") == 0);
  CHECK(count("ros", "SML1204") == 1);
  CHECK(count("", "SML1204") == 1);
  CHECK(count("drake", "SML1450") == 0);
  CHECK(count("drake", "SML1451") == 0);
  CHECK(count("", "SML1451") == 1);
  robot.replace(robot.find("type=\"ball\""), 11, "type=\"revolute\"");
  CHECK(count("drake", "SML1450") == 1);
  CHECK(count("", "SML1450") == 0);
  CHECK(count("ros", "SML1450") == 0);
}

TEST_CASE("Drake reads nothing in what it is told to ignore") {
  constexpr std::string_view kBroken = "<visual/><collision>";
  CHECK(answer_for("drake", "<collision>", kBroken) == Answer::refuses);
  std::string robot = "<link name=\"c\" drake_ignore=\"true\"><visual/></link><joint name";
  CHECK(answer_for("drake", "<joint name", robot) == Answer::takes);
  robot.replace(robot.find("true"), 4, "no");
  CHECK(answer_for("drake", "<joint name", robot) == Answer::refuses);
}

TEST_CASE("what has a prefix is missing, and no slip in what it resembles") {
  using enum Answer;
  for (const std::string_view target : {"ros", "gazebo", "dart", "mujoco"}) {
    CAPTURE(target);
    CHECK(answer_for(target, "<parent link=\"base\"/>", "<u:parent link=\"base\"/>") == refuses);
  }
  CHECK(answer_for("ros", "effort=", "ns:effort=") == refuses);
  CHECK(answer_for("mujoco", "<sphere", "<u:sphere") == refuses);
}

TEST_CASE("readers differ in the numbers at the edge of what a double holds") {
  using enum Answer;
  CHECK(answer_for("ros", "effort=\"1\"", "effort=\"5e-324\"") == loses);
  CHECK(answer_for("gazebo", "effort=\"1\"", "effort=\"5e-324\"") == refuses);
  CHECK(answer_for("mujoco", "effort=\"1\"", "effort=\"5e-324\"") == refuses);
  CHECK(answer_for("ros", "xyz=\"0 0 1\"", "xyz=\"0 0 1e308\"") == loses);
  CHECK(answer_for("mujoco", "xyz=\"0 0 1\"", "xyz=\"0 0 1e308\"") == loses);
}

TEST_CASE("an expression of xacro in a number of mimic is refused") {
  using enum Answer;
  constexpr std::string_view kEnd = "</joint>";
  constexpr std::string_view kMimic = "<mimic joint=\"a\" offset=\"$(arg m)\"/></joint>";
  CHECK(answer_for("ros", kEnd, kMimic) == refuses);
  CHECK(answer_for("mujoco", kEnd, kMimic) == refuses);
}

TEST_CASE("a number that is followed by a unit is no mass of a root") {
  CHECK(answer_for("gazebo", "<mass value=\"1\"/>", "<mass value=\"42 kg\"/>") == Answer::refuses);
}

TEST_CASE("a joint from a link to itself harms who meets that link only") {
  using enum Answer;
  constexpr std::string_view kApart =
      "<link name=\"z\"/><joint name=\"zz\" type=\"continuous\"><parent link=\"z\"/>"
      "<child link=\"z\"/></joint></robot>";
  CHECK(answer_for("gazebo", "</robot>", kApart) == loses);
  CHECK(answer_for("dart", "</robot>", kApart) == loses);
}

TEST_CASE("sdformat reads numbers of sensors, and poses of models") {
  using enum Answer;
  const auto add = [](std::string_view gazebo) {
    return answer_for("gazebo", "</robot>", std::string(gazebo) + "</robot>");
  };
  constexpr std::string_view kBegin =
      "<gazebo reference=\"arm\"><sensor name=\"s\" type=\"camera\"><camera><clip><near>";
  constexpr std::string_view kEnd = "</near></clip></camera></sensor></gazebo>";
  CHECK(add(std::string(kBegin) + "0.1m" + std::string(kEnd)) == takes);
  CHECK(add(std::string(kBegin) + "word" + std::string(kEnd)) == refuses);
  CHECK(add("<gazebo reference=\"arm\"><laserRetro>x</laserRetro></gazebo>") == refuses);
  CHECK(add("<gazebo><pose>1 2 3</pose></gazebo>") == refuses);
  CHECK(add("<gazebo><pose>1 2 3 0 0 0</pose></gazebo>") == takes);
}

TEST_CASE("MuJoCo adds moments of inertia as it compares them") {
  CHECK(answer_for("mujoco", "ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"",
                   "ixx=\"0.30000000000000004\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" "
                   "izz=\"0.2\"") == Answer::takes);
}

TEST_CASE("MuJoCo counts the numbers of a vector before it uses them") {
  constexpr const char* kMeshes[] = {"a.obj", "a"};
  const auto answer_with = [&](std::string_view mesh) {
    return answer_to("mujoco", damaged("<sphere radius=\"1\"/>", std::string(mesh)), kMeshes);
  };
  using enum Answer;
  CHECK(answer_with("<mesh filename=\"a.obj\" scale=\"0x2 1 1\"/>") == loses);
  CHECK(answer_with("<mesh filename=\"a.obj\" scale=\"0x2\"/>") == refuses);
  CHECK(answer_with("<mesh filename=\"a.obj\" scale=\"inf 1 1\"/>") == loses);
  CHECK(answer_with("<mesh filename=\"a.obj\" scale=\"inf 1 1 1\"/>") == refuses);
  CHECK(answer_with("<mesh filename=\"a.obj\" scale=\"infinity 1 1\"/>") == refuses);
  CHECK(answer_with("<mesh filename=\"a\"/>") == refuses);
}

TEST_CASE("nobody misses an attribute of a second element, and nobody knows what follows a root") {
  using enum Answer;
  CHECK(answer_for("ros", "<axis xyz=\"0 0 1\"/>",
                   "<axis xyz=\"0 0 1\"/><safety_controller "
                   "k_velocity=\"1\"/><safety_controller/>") == loses);
  CHECK(answer_for("gazebo", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 1\"/><axis/>") != refuses);
  const std::string robot(kRobot);
  CHECK(answer_to("ros", robot + robot) == loses);
  CHECK(answer_to("ros", robot + "<link name=\"more\"/>") == unknown);
}

TEST_CASE("urdfdom skips a tab in front of a number, but not behind one") {
  CHECK(answer_for("ros", "xyz=\"0 0 1\"", "xyz=\"0 \t0 1\"") != Answer::refuses);
  CHECK(answer_for("ros", "xyz=\"0 0 1\"", "xyz=\"0\t 0 1\"") == Answer::refuses);
}

TEST_CASE("DART reads `file:` as a URI, and does not look beside the robot for its file") {
  using enum Answer;
  const auto answer_with = [](std::string_view path) {
    return answer_for("dart", "<sphere radius=\"1\"/>",
                      "<mesh filename=\"" + std::string(path) + "\"/>");
  };
  CHECK(answer_with("file:gone.obj") == refuses);
  CHECK(answer_with("file://gone.obj") == refuses);
}

TEST_CASE("DART starts in the middle of limits without 0") {
  using enum Answer;
  const auto answer_with = [](const std::string& type, const std::string& bounds) {
    return answer_for("dart", R"(type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit lower="-1" upper="1")",
                      "type=\"" + type + R"(">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit )" + bounds);
  };
  CHECK(answer_with("revolute", R"(lower="-1e300" upper="1")") < refuses);
  CHECK(answer_with("continuous", R"(lower="1e154" upper="1")") < refuses);
  CHECK(answer_with("continuous", R"(lower="1e200" upper="1")") == refuses);
  CHECK(answer_with("revolute", R"(lower="1" upper="1e200")") == refuses);
  CHECK(answer_with("prismatic", R"(lower="1" upper="1e200")") < refuses);
  CHECK(answer_with("prismatic", R"(lower="1e308" upper="1.7e308")") == refuses);
}

TEST_CASE("a number that is too large is also judged by its sign") {
  using enum Answer;
  CHECK(answer_for("dart", R"(radius="1")", R"(radius="1e61")") < refuses);
  CHECK(answer_for("dart", R"(radius="1")", R"(radius="-1e61")") == refuses);
  CHECK(answer_for("mujoco", R"(radius="1")", R"(radius="-1e61")") == refuses);
  CHECK(answer_for("mujoco", R"(mass value="1")", R"(mass value="-1e61")") == refuses);
  CHECK(answer_for("gazebo", R"(mass value="1")", R"(mass value="-1e61")") == refuses);
}

TEST_CASE("whether printf ends urdfdom at `%` in a cylinder is not known") {
  const std::string_view cylinder = R"(cylinder length="1" radius="%s")";
  for (const char* target : {"ros", "gazebo", "dart"}) {
    CHECK(answer_for(target, R"(sphere radius="1")", cylinder) == Answer::unknown);
  }
  CHECK(answer_for("ros", R"(radius="1")", R"(radius="%s")") == Answer::refuses);
}
