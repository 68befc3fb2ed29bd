// SPDX-License-Identifier: BSD-3-Clause
// The effect of each export option; everything else stays unchanged.
#include <doctest/doctest.h>

#include "unit/exported.hpp"

using namespace smurf;
using namespace smurf::test;

TEST_CASE("without options nothing changes, and all that is lost is said") {
  const Read lamp(kUrdf, kAnnotations);
  const Exported exported(lamp, {});
  CHECK(exported.text == kUrdf);
  CHECK(exported.losses ==
        "SML8002 `diffuseColor` of material `red` differs from the URDF, which is kept; see "
        "--apply materials\n"
        "SML8001 `shininess` of material `red` has no place in a URDF\n"
        "SML8001 `p` of motor `hinge` has no place in a URDF\n"
        "SML8002 `maxValue` of motor `hinge` differs from the URDF, which is kept; see --apply "
        "limits\n"
        "SML8002 `maxSpeed` of motor `hinge` differs from the URDF, which is kept; see --apply "
        "limits\n"
        "SML8001 `type` of motor `tilt` has no place in a URDF\n"
        "SML8002 `mimic_motor` of motor `tilt` differs from the URDF, which is kept; see --apply "
        "mimic\n"
        "SML8002 `mimic_multiplier` of motor `tilt` differs from the URDF, which is kept; see "
        "--apply mimic\n"
        "SML8002 `maxEffort` of motor `again` differs from the URDF, which is kept; see --apply "
        "limits\n"
        "SML8002 `springDamping` of joint `hinge` differs from the URDF, which is kept; see "
        "--apply dynamics\n"
        "SML8001 `battery` has no place in a URDF\n");
}

TEST_CASE("what stands in an extension already is lost with it only") {
  UrdfExport options;
  options.strips_extensions = true;
  const Exported stripped(Read(kUrdf, kAnnotations), options);
  CHECK(stripped.loses("SML8002 sensor `s` is not written; see --sensors gazebo"));
  CHECK(stripped.loses("SML8001 `type` of motor `hinge` has no place in a URDF"));
}

TEST_CASE("keys that nothing takes over are lost, under every option") {
  const std::string annotations = R"(motors:
- {name: tilt, joint: tilt, type: PID, motorMaxForce: 7, minValue: -1, maxValue: 3.141592653589793}
materials:
- {name: red, diffuseFront: {r: 0.9, g: 0, b: 0, a: 1}}
joint:
- {name: hinge, springDamping: 0.5, damping_const_constraint_axis1: 0.25}
sensors:
- {name: view, type: CameraSensor, link: eye, width: 4, height: 3, hud_idx: 1}
- {name: force, type: Joint6DOF, link: eye}
- {name: nowhere, type: Joint6DOF, link: stand}
- {name: where, type: NodePosition, link: eye, id: [eye]}
)";
  UrdfExport options;
  options.apply = {true, true, true, true};
  options.actuation = Actuation::ros2_control;
  options.adds_gazebo_sensors = true;
  const Exported exported(Read(kUrdf, annotations), options);
  for (const char* loss :
       {"SML8002 `motorMaxForce` of motor `tilt` is an old name, which is not applied; rename it "
        "to `maxEffort`",
        "SML8001 `minValue` of motor `tilt` has no place in a URDF: a continuous joint has no "
        "bounds",
        "SML8002 `diffuseFront` of material `red` is an old name, which is not applied; rename it "
        "to `diffuseColor`",
        "SML8003 `damping_const_constraint_axis1` of joint `hinge` differs from `springDamping`, "
        "which is applied",
        "SML8001 `hud_idx` of sensor `view` has no place in a sensor of Gazebo",
        "SML8001 sensor `nowhere` is not written: it lacks a name, or a link or joint that "
        "carries it",
        "SML8001 sensor `where` has no place in a URDF"}) {
    CHECK_MESSAGE(exported.loses(loss), loss);
  }
  CHECK(exported.has("<gazebo reference=\"eye_mount\">\n    <sensor name=\"force\""));
  CHECK(exported.losses.find("maxValue") == std::string::npos);  // a whole turn
  CHECK(exported.losses.find("`type`") == std::string::npos);
}

TEST_CASE("annotations are applied where they differ, and only there") {
  const Read lamp(kUrdf, kAnnotations);
  UrdfExport options;
  options.apply.materials = true;
  CHECK(Exported(lamp, options).text == replaced(kUrdf, "1.0 0 0 1", "0.9 0 0 1"));
  options = {};
  options.apply.limits = true;
  const Exported limits(lamp, options);
  CHECK(limits.text == replaced(replaced(kUrdf, "upper=\"1\"", "upper=\"0.75\""),
                                "effort=\"10\" velocity=\"2\"", "effort=\"10\" velocity=\"2.5\""));
  CHECK(limits.losses.find("SML8003 two motors drive the joint `hinge`") != std::string::npos);
  options = {};
  options.apply.dynamics = true;
  CHECK(Exported(lamp, options).text ==
        replaced(kUrdf, "effort=\"10\" velocity=\"2\"/>\n",
                 "effort=\"10\" velocity=\"2\"/>\n    <dynamics damping=\"0.5\"/>\n"));
  options = {};
  options.apply.mimic = true;
  CHECK(Exported(lamp, options)
            .has("    <limit effort=\"1\" velocity=\"1\"/>\n"
                 "    <mimic joint=\"hinge\" multiplier=\"2\" offset=\"0\"/>\n  </joint>"));
}

TEST_CASE("an annotation reaches all definitions of a material, and the proof expects that") {
  const std::string ball = "<visual><geometry><sphere radius=\"1\"/></geometry>";
  const std::string eye =
      "<link name=\"eye\">" + ball + "<material name=\"blue\"/></visual></link>";
  const std::string shade =
      "<link name=\"shade\">" + ball +
      "<material name=\"blue\"><color rgba=\"0 0 1 1\"/></material></visual>" + ball +
      "<material name=\"blue\"><color rgba=\"0 0 0.5 1\"/></material>"
      "</visual></link>";
  const std::string urdf =
      replaced(replaced(kUrdf, "<link name=\"eye\"/>", eye), "<link name=\"shade\"/>", shade);
  const Read lamp(urdf, R"(materials:
- {name: blue, shininess: 3}
- {name: blue, diffuseColor: {r: 0, g: 0, b: 0.25, a: 1}}
- {name: blue, diffuseColor: {r: 0, g: 0, b: 0.75, a: 1}}
)");
  UrdfExport options;
  options.apply.materials = true;
  const Exported exported(lamp, options);
  CHECK(exported.text ==
        replaced(replaced(urdf, "0 0 1 1\"", "0 0 0.25 1\""), "0 0 0.5 1\"", "0 0 0.25 1\""));

  const auto difference = [&](const std::string& text, const UrdfExport& scope) {
    return compare_models(lamp.model, Read(text).model, proof_scope(scope)).difference;
  };
  CHECK(difference(exported.text, options).empty());
  CHECK(difference(exported.text, {}) == "the material of a visual of the link `eye` differs");
  CHECK(difference(urdf, options) == "the material of a visual of the link `eye` differs");
  CHECK(difference(replaced(urdf, "0 0 0.5 1\"", "0 0 1 1\""), {}) ==
        "the material of a visual of the link `shade` differs");
  CHECK(difference(replaced(exported.text, "1.0 0 0 1", "0 1 0 1"), options) ==
        "the material of a visual of the link `bulb` differs");
}

TEST_CASE("comments and extensions are taken away with their lines") {
  UrdfExport options;
  options.strips_comments = true;
  CHECK(Exported(Read(kUrdf), options).text == replaced(kUrdf, "  <!-- a comment -->\n", ""));
  options = {};
  options.strips_extensions = true;
  const Exported stripped(Read(kUrdf), options);
  CHECK_FALSE(stripped.has("gazebo"));
  CHECK(stripped.has("</joint>\n</robot>"));
  CHECK(stripped.losses == "SML8004 `gazebo` is left out\nSML8004 `transmission` is left out\n");
}

TEST_CASE("a prefix reaches everything that refers to a name") {
  UrdfExport options;
  options.prefix = "l_";
  const Exported prefixed(Read(kUrdf), options);
  for (const char* part :
       {"<material name=\"l_red\">", "<link name=\"l_eye\"/>", "<joint name=\"l_hinge\" ",
        "<parent link=\"l_bulb\"/>", "<gazebo reference=\"l_eye\">", "<frame>l_eye</frame>",
        "<topic>eyes</topic>", "<transmission name=\"l_t\"><joint name=\"l_hinge\"/>",
        "<material name=\"l_red\"/>", "<robot name=\"lamp\">"}) {
    CHECK_MESSAGE(prefixed.has(part), part);
  }
}

TEST_CASE("a prefix leaves the world alone") {
  UrdfExport options;
  options.prefix = "l_";
  const Read fixed(replaced(tower("<gazebo reference=\"base\"><a/></gazebo>\n"), "</robot>",
                            "  <link name=\"world\"/>\n"
                            "  <joint name=\"world\" type=\"fixed\">"
                            "<parent link=\"world\"/><child link=\"base\"/></joint>\n</robot>"));
  const Exported prefixed(fixed, options);
  CHECK(prefixed.has("<link name=\"world\"/>"));
  CHECK(prefixed.has("<joint name=\"l_world\" type=\"fixed\"><parent link=\"world\"/>"
                     "<child link=\"l_base\"/>"));
  CHECK(compare_models(fixed.model, Read(prefixed.text).model, proof_scope(options)).holds());
}

TEST_CASE("MuJoCo is told where meshes are, unless the author has") {
  UrdfExport options;
  options.adds_mujoco_settings = true;
  const auto exported = [&](const std::string& settings) {
    return Exported(Read(tower(settings)), options);
  };
  CHECK(exported("").has("  <mujoco>\n    <compiler strippath=\"false\"/>\n  </mujoco>\n"));
  CHECK(
      exported("  <mujoco><size njmax=\"1\"/></mujoco>\n").has("<compiler strippath=\"false\"/>"));
  const std::string own = "<mujoco><compiler strippath=\"true\"/></mujoco>\n";
  CHECK(exported(own).text == tower(own));
}

TEST_CASE("bases and versions") {
  UrdfExport options;
  options.base = BaseJoint::floating;
  const Exported floating(Read(kUrdf), options);
  CHECK(floating.has("  <link name=\"world\"/>\n"
                     "  <joint name=\"world_to_stand\" type=\"floating\">\n"
                     "    <parent link=\"world\"/>\n"
                     "    <child link=\"stand\"/>\n"
                     "  </joint>\n</robot>"));
  options = {};
  options.version = "1.1";
  CHECK(Exported(Read(kUrdf), options).has("<robot name=\"lamp\" version=\"1.1\">"));
}

TEST_CASE("an older version says what it can in its own words") {
  const Read newer(R"(<robot name="r" version="1.2">
  <link name="a">
    <collision name="c">
      <origin xyz="0 0 1" quat_xyzw="0 0 0.7071067811865476 0.7071067811865476"/>
      <geometry><capsule radius="0.5" length="2"/></geometry>
    </collision>
  </link>
  <link name="b"/>
  <joint name="j" type="revolute">
    <parent link="a"/><child link="b"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="1" effort="1" velocity="1" acceleration="2" jerk="3"/>
  </joint>
</robot>
)");
  UrdfExport options;
  options.version = "1.0";
  const Exported old(newer, options);
  CHECK(old.has("<robot name=\"r\" version=\"1.0\">"));
  CHECK(old.has("    <collision name=\"c\">\n      <origin xyz=\"0 0 1\" rpy=\"0 0 1.57"));
  CHECK(old.has("<cylinder radius=\"0.5\" length=\"2\"/>"));
  CHECK(old.has("    <collision name=\"c_top\">\n      <origin xyz=\"0 0 2\" rpy=\"0 0 1.57"));
  CHECK(old.has("    <collision name=\"c_bottom\">\n      <origin xyz=\"0 0 0\" rpy=\"0 0 1.57"));
  CHECK(old.has("<geometry><sphere radius=\"0.5\"/></geometry>"));
  CHECK(old.has("velocity=\"1\"/>"));
  CHECK(old.losses == "SML8001 `acceleration` has no place in a URDF of version 1.0\n"
                      "SML8001 `jerk` has no place in a URDF of version 1.0\n");
  CHECK(compare_models(newer.model, Read(old.text).model, proof_scope(options)).holds());
  options.version = "1.1";
  const Exported middle(newer, options);
  CHECK(middle.has("capsule"));
  CHECK(middle.has("quat_xyzw"));
  CHECK_FALSE(middle.has("jerk"));
}

TEST_CASE("the canonical form does not depend on order and notation") {
  UrdfExport options;
  options.is_canonical = true;
  const Exported canonical(Read(kUrdf), options);
  CHECK(canonical.has("<limit lower=\"-1\" upper=\"1\" effort=\"10\" velocity=\"2\"/>"));
  CHECK(canonical.text.find("name=\"hinge\"") < canonical.text.find("link name=\"arm\""));
  CHECK(canonical.has("  <gazebo reference=\"eye\"><sensor name=\"s\" type=\"imu\">"));
  std::string other = replaced(kUrdf, "lower=\"-1.0\" upper=\"1\"", "upper=\"1e0\" lower=\"-1\"");
  other = replaced(other, "<link name=\"eye\"/>", "");
  other = replaced(other, "  <gazebo ", "  <link name=\"eye\"/>\n  <gazebo ");
  CHECK(Exported(Read(other), options).text == canonical.text);
}

TEST_CASE("the canonical form has the order of the rows, except for those that are last") {
  UrdfExport options;
  options.is_canonical = true;
  const std::string mixed =
      "<mimic offset=\"0\" multiplier=\"2\" joint=\"tilt\"/>"
      "<limit velocity=\"2\" jerk=\"9\" effort=\"10\" upper=\"1\" lower=\"-1\"/>"
      "<safety_controller soft_lower_limit=\"0\" k_velocity=\"1\" k_position=\"2\"/>"
      "<dynamics friction=\"1\" damping=\"2\"/><calibration rising=\"1\" falling=\"0.5\"/>";
  const std::string limit = "<limit lower=\"-1.0\" upper=\"1\" effort=\"10\" velocity=\"2\"/>";
  const Exported canonical(Read(replaced(kUrdf, limit, mixed)), options);
  CHECK(canonical.has(
      "    <calibration falling=\"0.5\" rising=\"1\"/>\n"
      "    <dynamics damping=\"2\" friction=\"1\"/>\n"
      "    <limit lower=\"-1\" upper=\"1\" effort=\"10\" velocity=\"2\" jerk=\"9\"/>\n"
      "    <mimic joint=\"tilt\" multiplier=\"2\" offset=\"0\"/>\n"
      "    <safety_controller k_position=\"2\" k_velocity=\"1\" "
      "soft_lower_limit=\"0\"/>\n"));
}

TEST_CASE("motors become extensions where no extension drives their joints") {
  const Read lamp(kUrdf, kAnnotations);
  UrdfExport options;
  options.actuation = Actuation::ros2_control;
  const Exported ros2(lamp, options);
  // ROS 2 does not read the transmission of the hinge. The other motor follows and gets no
  // command.
  CHECK(ros2.has("  <ros2_control name=\"lamp\" type=\"system\">\n"));
  CHECK(ros2.has("    <joint name=\"hinge\">\n      <command_interface name=\"position\">\n"));
  CHECK(ros2.has("    <joint name=\"tilt\">\n      <state_interface name=\"position\"/>\n"));
  CHECK_FALSE(ros2.has("<transmission"));
  CHECK(ros2.losses.find("SML8004 `transmission` is left out for ros2_control") !=
        std::string::npos);
  options.actuation = Actuation::transmission;
  const Exported transmissions(lamp, options);
  CHECK(transmissions.has("  <transmission name=\"tilt_transmission\">\n"));
  CHECK_FALSE(transmissions.has("hinge_transmission"));
  CHECK(transmissions.losses.find("`type` of motor") == std::string::npos);
  const Read free(
      replaced(kUrdf, "<transmission name=\"t\"><joint name=\"hinge\"/></transmission>", ""),
      kAnnotations);
  CHECK(Exported(free, options).has("hardware_interface/PositionJointInterface"));
}

TEST_CASE("sensors become those of Gazebo, once") {
  UrdfExport options;
  options.adds_gazebo_sensors = true;
  CHECK(Exported(Read(kUrdf, kAnnotations), options).text == kUrdf);
  const std::size_t begin = kUrdf.find("  <gazebo");
  const std::size_t end = kUrdf.find("</gazebo>\n") + 10;
  const std::string plain = kUrdf.substr(0, begin) + kUrdf.substr(end);
  const std::string sensors =
      "sensors:\n"
      "- {name: s, type: NodeIMU, link: eye, id: [eye], rate: 20}\n"
      "- {name: c, type: CameraSensor, link: eye, width: 64, height: 32, opening_width: 90,\n"
      "   position_offset: {x: 1, y: 2, z: 3}, orientation_offset: {roll: 0, pitch: 0, yaw: 90}}\n"
      "- {name: r, type: NodeRotation, link: eye, id: [eye]}\n"
      "- {name: d, type: RaySensor, link: eye, width: 9, opening_width: 2, max_distance: 5}\n"
      "- {name: e, type: RaySensor, link: eye, width: 3}\n"
      "- {name: f, type: MultiLevelLaserRangeFinder, link: eye, numRaysHorizontal: 4,\n"
      "   numRaysVertical: 2, horizontalOpeningAngle: 3, verticalOpeningAngle: 0.5}\n"
      "- {name: p, type: JointPosition, id: [hinge]}\n";
  const Exported exported(Read(plain, sensors), options);
  CHECK(exported.has("  <gazebo reference=\"eye\">\n    <sensor name=\"s\" type=\"imu\">\n"
                     "      <update_rate>50</update_rate>\n    </sensor>\n  </gazebo>\n"));
  CHECK(exported.has("<pose>1 2 3 0 0 1.570796"));
  CHECK(exported.has("<horizontal_fov>1.570796"));
  CHECK(exported.has("<sensor name=\"r\" type=\"imu\">"));
  CHECK(exported.has("<sensor name=\"d\" type=\"gpu_lidar\">"));
  CHECK(exported.has("<samples>9</samples>"));
  // The rays of MARS are 2/9 rad apart.
  CHECK(exported.has("<min_angle>-0.8888888888888888</min_angle>"));
  CHECK(exported.has("<max>5</max>"));
  // Without opening_width, it is pi/2, and two rays are a third of it apart.
  CHECK(exported.has("<min_angle>-0.5235987755982988</min_angle>"));
  CHECK(exported.has("<samples>2</samples>"));
  CHECK(exported.has("<min_angle>-3</min_angle>"));
  CHECK(exported.has("<max_angle>0.25</max_angle>"));
  CHECK(exported.losses == "SML8001 sensor `p` has no place in a URDF\n");
}

TEST_CASE("mesh addresses") {
  const std::string urdf =
      replaced(kUrdf, "<sphere radius=\"0.02\"/>",
               "<mesh filename=\"m/a&amp;b.stl\"/></geometry></visual><visual><geometry>"
               "<mesh filename=\"package://elsewhere/c.stl\"/>");
  Read lamp(urdf);
  lamp.files.add("/lamp/m/a&b.stl", "");
  LoadContext context{lamp.sources, lamp.files, lamp.sink, {}, {}};
  const LinkedModel model = load_model("/lamp/lamp.urdf", context);
  DiagnosticSink sink;
  const auto filename = [&](MeshUri form) {
    UrdfExport options;
    options.output_folder = "/out";
    options.mesh_uri = form;
    options.package_name = "lamp_description";
    options.package_folder = "/lamp";
    const std::string text = export_urdf(model, lamp.sources, options, sink);
    CHECK(text.find("package://elsewhere/c.stl") != std::string::npos);  // it leads nowhere
    const std::size_t begin = text.find("<mesh filename=\"") + 16;
    return text.substr(begin, text.find('"', begin) - begin);
  };
  CHECK(filename(MeshUri::rebase) == "../lamp/m/a&amp;b.stl");
  CHECK(filename(MeshUri::relative) == "../lamp/m/a&amp;b.stl");
  CHECK(filename(MeshUri::absolute) == "/lamp/m/a&amp;b.stl");
  CHECK(filename(MeshUri::file) == "file:///lamp/m/a&amp;b.stl");
  CHECK(filename(MeshUri::package) == "package://lamp_description/m/a&amp;b.stl");
  CHECK(filename(MeshUri::keep) == "m/a&amp;b.stl");
}
