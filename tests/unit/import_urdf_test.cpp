// SPDX-License-Identifier: BSD-3-Clause
// The SMURF models that are made from the constructs of a URDF.
#include <doctest/doctest.h>

#include "smurf/convert.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"
#include "smurf/write.hpp"

using namespace smurf;

namespace {

/// A robot of a base and movable links l1, l2, ...; `more` is appended.
std::string robot(const std::string& joints, const std::string& more) {
  std::string text = "<robot name=\"bot\">\n<link name=\"base\"/>\n";
  for (int i = 1; i <= 4; ++i) {
    text += "<link name=\"l" + std::to_string(i) +
            "\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" "
            "iyz=\"0\" izz=\"1\"/></inertial><collision><geometry><sphere "
            "radius=\"1\"/></geometry></collision></link>\n";
  }
  return text + joints + more + "</robot>\n";
}

std::string joint(const std::string& name, const std::string& link, const std::string& type,
                  const std::string& more = {}) {
  const std::string bounds = type == "continuous" ? "" : "lower=\"-1\" upper=\"2\" ";
  return "<joint name=\"" + name + "\" type=\"" + type +
         "\"><parent link=\"base\"/><child link=\"" + link + "\"/><axis xyz=\"0 0 1\"/><limit " +
         bounds + "effort=\"30\" velocity=\"4\"/>" + more + "</joint>\n";
}

const std::string kFourJoints =
    joint("j1", "l1", "revolute") + joint("j2", "l2", "continuous") +
    joint("j3", "l3", "prismatic") +
    joint("j4", "l4", "revolute", "<mimic joint=\"j1\" offset=\"0.1\"/>");

std::string transmission(const std::string& joint, const std::string& interface) {
  return "<transmission name=\"t_" + joint +
         "\"><type>transmission_interface/SimpleTransmission</type><joint name=\"" + joint +
         "\"><hardwareInterface>hardware_interface/" + interface +
         "</hardwareInterface></joint><actuator name=\"a\"/></transmission>\n";
}

struct Imported {
  SourceMap sources;
  MemoryFiles files;
  DiagnosticSink sink;
  LinkedModel source;
  std::vector<TextFile> texts;
  LinkedModel result;

  Imported(const std::string& urdf, UrdfImport options = {}, const std::string& srdf = {}) {
    files.add("/bot/bot.urdf", urdf);
    files.add("/bot/textures/wood.png", "");
    files.add("/bot/bot.srdf", srdf);
    LoadContext context{sources, files, sink, {}, {}};
    source = load_model("/bot/bot.urdf", context);
    REQUIRE(source.robot);
    std::optional<xml::Document> document;
    if (!srdf.empty()) document = load_xml("/bot/bot.srdf", context);
    options.name = "bot";
    options.output_folder = options.layout == SmurfLayout::in_place ? "/bot" : "/bot/out";
    options.srdf = document ? &*document : nullptr;
    texts = write_smurf(import_urdf(source, sources, options, sink));
    for (const TextFile& file : texts)
      files.add(options.output_folder + "/" + file.path, file.text);
    result = load_model(options.output_folder + "/" + texts.back().path, context);
    REQUIRE(result.robot);
    CHECK(compare_models(source, result).holds());
    lint_model(result, {}, sink);
  }

  const std::string& text(const std::string& path) const {
    for (const TextFile& file : texts) {
      if (file.path == path) return file.text;
    }
    FAIL("no file ", path);
    return texts.front().text;
  }

  /// "SML8101: message", one per line; without findings about the URDF itself.
  std::string findings() const {
    std::string all;
    for (const Diagnostic& diagnostic : sink.diagnostics()) {
      if (diagnostic.rule->id.starts_with("SML1")) continue;
      all += std::string(diagnostic.rule->id) + ": " + diagnostic.message + "\n";
    }
    return all;
  }
};

}  // namespace

TEST_CASE("the main file lists the URDF and the annotation files") {
  const Imported bot(robot(kFourJoints, transmission("j1", "PositionJointInterface")));
  CHECK(bot.text("smurf/bot.smurf") == "# made by urdf2smurf from bot.urdf\n"
                                       "\n"
                                       "modelname: bot\n"
                                       "files:\n"
                                       "- ../urdf/bot.urdf\n"
                                       "- bot_motors.yml\n"
                                       "- bot_urdf_extensions.yml\n");
  CHECK(bot.texts.size() == 4);
  CHECK(bot.findings().empty());
}

TEST_CASE("layouts") {
  const std::string urdf = robot(kFourJoints, "");
  CHECK(Imported(urdf, {.layout = SmurfLayout::flat}).text("bot.smurf").find("- bot.urdf\n") !=
        std::string::npos);
  const Imported in_place(urdf, {.layout = SmurfLayout::in_place});
  CHECK(in_place.texts.size() == 1);
  CHECK(in_place.text("bot.smurf").find("- bot.urdf\n") != std::string::npos);
}

TEST_CASE("simple transmissions become motors, with the limits of their joints") {
  const Imported bot(robot(kFourJoints, transmission("j3", "EffortJointInterface") +
                                            transmission("j1", "PositionJointInterface") +
                                            transmission("j2", "VelocityJointInterface")));
  const std::vector<Motor>& motors = bot.result.annotations.motors;
  REQUIRE(motors.size() == 4);  // in the order of the joints
  CHECK(*motors[0].joint == "j1");
  CHECK(*motors[0].name == "j1");
  CHECK(*motors[0].type == "PID");
  CHECK(*motors[0].min_value == -1);
  CHECK(*motors[0].max_value == 2);
  CHECK(*motors[0].max_effort == 30);
  CHECK(*motors[0].max_speed == 4);
  CHECK(motors[0].p);
  CHECK(*motors[1].type == "DC");
  CHECK(*motors[1].max_value == doctest::Approx(3.14159265358979));
  CHECK_FALSE(motors[1].p.written);
  CHECK(*motors[2].type == "direct_effort");
  // The fourth joint mimics the first, which MARS reads from motors only.
  CHECK(*motors[3].mimic_motor == "j1");
  CHECK(*motors[3].mimic_multiplier == 1);
  CHECK(*motors[3].mimic_offset == 0.1);
  CHECK(bot.text("smurf/bot_motors.yml").find("# from a transmission, bot.urdf:12\n- name: j1\n") !=
        std::string::npos);
}

TEST_CASE("what drives no joint directly, or only observes, becomes no motor") {
  const Imported bot(robot(
      kFourJoints, transmission("j1", "JointStateInterface") +
                       "<transmission name=\"differential\"><type>x/DifferentialTransmission</type>"
                       "<joint name=\"j2\"/><joint name=\"j3\"/></transmission>"));
  CHECK(bot.result.annotations.motors.empty());
  CHECK(bot.findings() ==
        "SML8101: the transmission `differential` cannot become an entry of a section: "
        "a SMURF motor drives one joint directly\n");
  const Imported all(robot(kFourJoints, ""), {.motors = MotorChoice::all});
  CHECK(all.result.annotations.motors.size() == 4);
  const Imported none(robot(kFourJoints, transmission("j1", "PositionJointInterface")),
                      {.motors = MotorChoice::none});
  CHECK(none.result.annotations.motors.empty());
}

TEST_CASE("ros2_control becomes motors and joint sensors, and may narrow limits") {
  const Imported bot(robot(kFourJoints, R"(<ros2_control name="r" type="system">
<joint name="j1"><command_interface name="velocity"><param name="max">1.5</param></command_interface>
  <command_interface name="position"><param name="min">-0.5</param><param name="max">9</param></command_interface>
  <state_interface name="position"/><state_interface name="effort"/></joint>
<joint name="j2"><command_interface name="effort"/><state_interface name="position"/></joint>
<joint name="j3"><state_interface name="velocity"/></joint>
<sensor name="ft"><state_interface name="force.x"/><param name="frame_id">l3</param></sensor>
<sensor name="tilt"><state_interface name="orientation.x"/><param name="frame_id">l1</param></sensor>
<sensor name="lost"><state_interface name="orientation.x"/></sensor>
</ros2_control>)"));
  const std::vector<Motor>& motors = bot.result.annotations.motors;
  REQUIRE(motors.size() == 3);  // j1, j2, and j4, which mimics j1
  CHECK(*motors[0].type == "PID");
  CHECK(*motors[0].min_value == -0.5);
  CHECK(*motors[0].max_value == 2);
  CHECK(*motors[0].max_speed == 1.5);
  CHECK(*motors[1].type == "direct_effort");
  const std::vector<Sensor>& sensors = bot.result.annotations.sensors;
  REQUIRE(sensors.size() == 5);
  CHECK(*sensors[0].type == "Joint6DOF");
  CHECK(*sensors[1].type == "NodeIMU");
  CHECK(bot.text("smurf/bot_sensors.yml").find("type: JointTorque\n  link: l1\n  id:\n  - j1\n") !=
        std::string::npos);
  CHECK(bot.findings() ==
        "SML8101: the sensor `lost` cannot become an entry of a section: no link `` carries it\n");
}

TEST_CASE("a motor has no empty range") {
  const std::string command =
      R"(<ros2_control name="r" type="system"><joint name="j1"><command_interface name="position">
<param name="min">3</param><param name="max">-3</param></command_interface></joint></ros2_control>)";
  const Imported bot(robot(kFourJoints, command));
  REQUIRE(!bot.result.annotations.motors.empty());
  CHECK(*bot.result.annotations.motors[0].min_value == -1);
  CHECK(*bot.result.annotations.motors[0].max_value == 2);
  std::string turned = kFourJoints;
  turned.replace(turned.find("upper=\"2\""), 9, "upper=\"-2\"");
  const Imported other(robot(turned, command));
  REQUIRE(!other.result.annotations.motors.empty());
  CHECK(!other.result.annotations.motors[0].min_value);
  CHECK(!other.result.annotations.motors[0].max_value);
}

TEST_CASE("sensors of Gazebo become those of MARS") {
  const Imported bot(robot(kFourJoints, R"(<gazebo reference="l1">
<sensor name="eye" type="camera"><update_rate>30</update_rate><pose>0.1 0 0 0 0 1.5707963267948966</pose>
  <camera><horizontal_fov>1.5707963267948966</horizontal_fov><image><width>640</width><height>320</height></image></camera></sensor>
<sensor name="scan" type="gpu_lidar"><ray><scan><horizontal><samples>90</samples><min_angle>-1</min_angle><max_angle>2</max_angle></horizontal>
  <vertical><samples>4</samples><min_angle>-0.2</min_angle><max_angle>0.4</max_angle></vertical></scan><range><min>0.1</min><max>20</max></range></ray></sensor>
<sensor name="imu" type="imu"/><sensor name="where" type="navsat"/></gazebo>
<gazebo reference="l2"><sensor name="bump" type="contact"><contact><collision>whatever</collision></contact></sensor></gazebo>
<gazebo reference="j3"><sensor name="push" type="force_torque"/></gazebo>
<gazebo reference="nobody"><sensor name="imu" type="imu"/></gazebo>
)"));
  const std::string& text = bot.text("smurf/bot_sensors.yml");
  const auto has = [&](const std::string& part) {
    CHECK_MESSAGE(text.find(part) != std::string::npos, part, "\n", text);
  };
  has("- name: eye\n  type: CameraSensor\n  link: l1\n  rate: 33  # ms; 30 Hz\n  width: 640\n"
      "  height: 320\n  opening_width: 90  # degrees; 1.5708 rad\n  opening_height: 53.13010");
  // Phobos reads a position only after an orientation.
  has("  orientation_offset: {w: 0.707106781");
  CHECK(text.find("orientation_offset") < text.find("  position_offset: {x: 0.1, y: 0, z: 0}\n"));
  has("  bands: 90\n  lasers: 4\n  opening_width: 3\n  opening_height: 0.6");
  has("  horizontal_offset: 0.5\n  vertical_offset: -0.1  # positive looks down\n");
  has("  min_distance: 0.1\n  max_distance: 20\n");
  has("- name: imu\n  type: NodeIMU\n  link: l1\n  id:\n  - l1\n");
  has("- name: bump\n  type: NodeContact\n  link: l2\n  id:\n  - l2_collision\n");
  has("- name: push\n  type: Joint6DOF\n  link: l3\n");
  CHECK(text.find("joint: ") == std::string::npos);  // where Phobos stops
  CHECK(
      bot.findings() ==
      "SML8101: the sensor `where` cannot become an entry of a section: MARS has no sensor of the type "
      "`navsat`\n"
      "SML8101: the sensor `imu` cannot become an entry of a section: no link `nobody` carries it\n");
}

TEST_CASE("a collision gets a name only when a sensor must refer to it") {
  const std::string bump =
      R"(<gazebo reference="l2"><sensor name="bump" type="contact"/></gazebo>)";
  const Imported bot(robot(kFourJoints, bump));
  CHECK(bot.text("urdf/bot.urdf").find("<collision name=\"l2_collision\">") != std::string::npos);
  CHECK(bot.text("urdf/bot.urdf").find("l1_collision") == std::string::npos);
  const Imported in_place(robot(kFourJoints, bump), {.layout = SmurfLayout::in_place});
  CHECK(in_place.result.annotations.sensors.empty());
  CHECK(in_place.findings().find("the URDF is not changed") != std::string::npos);
}

TEST_CASE("colours, textures and damping") {
  const std::string more = R"(<material name="wood"><color rgba="0.1 0.2 0.3 1"/>
<texture filename="textures/wood.png"/></material><material name="wood"/>
<material name="gone"><texture filename="textures/gone.png"/></material>)";
  const Imported bot(robot(joint("j1", "l1", "revolute", "<dynamics damping=\"0.5\"/>") +
                               joint("j2", "l2", "revolute") + joint("j3", "l3", "fixed") +
                               joint("j4", "l4", "fixed"),
                           more));
  CHECK(bot.text("smurf/bot_materials.yml")
            .find("- name: wood\n  diffuseColor: {r: 0.1, g: 0.2, b: 0.3, a: 1}\n"
                  "  diffuseTexture: ../../textures/wood.png\n") != std::string::npos);
  CHECK(bot.result.annotations.materials.size() == 1);
  CHECK(bot.text("urdf/bot.urdf").find("filename=\"../../textures/wood.png\"") !=
        std::string::npos);
  REQUIRE(bot.result.annotations.joints.size() == 1);
  CHECK(bot.text("smurf/bot_joint.yml").find("springDamping: 0.5\n") != std::string::npos);
}

TEST_CASE("group states of an SRDF become joint pose sets") {
  const Imported bot(robot(kFourJoints, ""), {}, R"(<robot name="bot">
<group_state name="home" group="arm"><joint name="j1" value="0.5"/><joint name="x" value="1"/></group_state>
<group_state name="rest" group="arm"><joint name="j1" value="0"/></group_state>
<group_state name="rest" group="hand"><joint name="j3" value="0.1"/></group_state>
<disable_collisions link1="l1" link2="l2" reason="Never"/></robot>)");
  const auto& poses = bot.result.annotations.poses;
  REQUIRE(poses.size() == 3);
  CHECK(*poses[0].name == "home");
  CHECK(*poses[1].name == "arm_rest");
  CHECK(*poses[2].name == "hand_rest");
  CHECK(*poses[2].joints.front().position == 0.1);
  CHECK(bot.text("smurf/bot_srdf_extensions.yml").find("<disable_collisions link1=") !=
        std::string::npos);
  CHECK(bot.findings() ==
        "SML8101: a position of `x` cannot become an entry of a section: the URDF has "
        "no such joint\n");
}

TEST_CASE("what has no section is kept as it stands") {
  const std::string extension =
      "<gazebo reference=\"l1\">\n    <mu1>0.9</mu1>  <!-- rubber: 100 % -->\n</gazebo>";
  const Imported bot(robot(kFourJoints, extension + "\n<gazebo reference=\"l1\"><x/></gazebo>"));
  REQUIRE(bot.result.annotations.custom.size() == 1);
  const CustomSection& section = bot.result.annotations.custom.front();
  CHECK(section.name.value == "urdf_extensions");
  const yaml::View texts(*bot.result.document(section.span.source), section.node);
  CHECK(texts.find("gazebo_l1").find("xml").text() ==
        extension + "\n<gazebo reference=\"l1\"><x/></gazebo>");
}

TEST_CASE("what is kept moves to the left as a whole") {
  const Imported bot(robot(kFourJoints, "  <gazebo>\n    <x>\n      <y/>\n    </x>\n  </gazebo>"));
  const CustomSection& section = bot.result.annotations.custom.front();
  const yaml::View texts(*bot.result.document(section.span.source), section.node);
  CHECK(texts.find("gazebo").find("xml").text() == "<gazebo>\n  <x>\n    <y/>\n  </x>\n</gazebo>");
}
