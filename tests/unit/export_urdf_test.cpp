// SPDX-License-Identifier: BSD-3-Clause
// What the options of an export change, and what they leave alone.
#include <doctest/doctest.h>

#include "smurf/convert.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"

using namespace smurf;

namespace {

const std::string kUrdf = R"(<robot name="lamp">
  <!-- a comment -->
  <material name="red">
    <color rgba="1.0 0 0 1"/>
  </material>
  <link name="stand">
    <inertial><mass value="2"/><inertia ixx="0.03" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.003"/></inertial>
  </link>
  <link name="arm">
    <inertial><origin xyz="0 0 0.1"/><mass value="0.5"/><inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.0002"/></inertial>
  </link>
  <link name="bulb">
    <inertial><origin rpy="0.3 0 0"/><mass value="0.25"/><inertia ixx="0.001" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.0025"/></inertial>
    <visual>
      <geometry>
        <sphere radius="0.02"/>
      </geometry>
      <material name="red"/>
    </visual>
  </link>
  <link name="eye"/>
  <link name="shade"/>
  <joint name="hinge" type="revolute">
    <origin xyz="0 0 0.4"/><parent link="stand"/><child link="arm"/><axis xyz="0 1 0"/>
    <limit lower="-1.0" upper="1" effort="10" velocity="2"/>
  </joint>
  <joint name="mount" type="fixed">
    <parent link="arm"/>
    <child link="bulb"/>
    <origin xyz="0 0.1 0.2" rpy="0 0 1.5"/>
  </joint>
  <joint name="eye_mount" type="fixed"><parent link="bulb"/><child link="eye"/></joint>
  <joint name="tilt" type="continuous">
    <parent link="bulb"/>
    <child link="shade"/>
    <axis xyz="1 0 0"/>
    <limit effort="1" velocity="1"/>
  </joint>
  <gazebo reference="eye"><sensor name="s" type="imu"><frame>eye</frame><topic>eyes</topic></sensor></gazebo>
  <transmission name="t"><joint name="hinge"/></transmission>
</robot>
)";

const std::string kAnnotations = R"(motors:
- {name: hinge, joint: hinge, type: PID, p: 3, minValue: -1, maxValue: 0.75, maxEffort: 10, maxSpeed: 2.5}
- {name: tilt, joint: tilt, type: PID, maxEffort: 1, maxSpeed: 1, mimic_motor: hinge, mimic_multiplier: 2}
- {name: again, joint: hinge, type: PID, maxEffort: 4}
materials:
- {name: red, diffuseColor: {r: 0.9, g: 0, b: 0, a: 1}, shininess: 3}
joint:
- {name: hinge, springDamping: 0.5, springStiffness: 0}
sensors:
- {name: s, type: NodeIMU, link: eye, id: [eye]}
urdf_extensions: {gazebo: {xml: ''}}
battery: {capacity: 3}
)";

struct Read {
  SourceMap sources;
  MemoryFiles files;
  DiagnosticSink sink;
  LinkedModel model;

  explicit Read(const std::string& urdf, const std::string& annotations = {}) {
    files.add("/lamp/lamp.urdf", urdf);
    files.add("/lamp/lamp_all.yml", annotations);
    files.add("/lamp/lamp.smurf", "modelname: lamp\nfiles: [lamp.urdf, lamp_all.yml]\n");
    LoadContext context{sources, files, sink, {}, {}};
    model = load_model(annotations.empty() ? "/lamp/lamp.urdf" : "/lamp/lamp.smurf", context);
    REQUIRE(model.robot);
  }
};

struct Exported {
  std::string text;
  std::string losses;  ///< "SML8001 message", a line each

  Exported(const Read& source, UrdfExport options) {
    options.output_folder = "/lamp";
    DiagnosticSink sink;
    report_losses(source.model, options, sink);
    text = export_urdf(source.model, source.sources, options, sink);
    for (const Diagnostic& loss : sink.diagnostics()) {
      losses += std::string(loss.rule->id) + " " + loss.message + "\n";
    }
    const Read result(text);
    const Proof proof = compare_models(source.model, result.model, proof_scope(options));
    if (!options.apply.mimic) CHECK_MESSAGE(proof.holds(), proof.difference);
    // Once more changes nothing; prefixes and bases add up on purpose.
    if (!options.prefix.empty() || options.base != BaseJoint::as_is) return;
    CHECK(export_urdf(result.model, result.sources, options, sink) == text);
  }

  bool has(const std::string& part) const { return text.find(part) != std::string::npos; }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("without options nothing changes, and all that is lost is said") {
  const Read lamp(kUrdf, kAnnotations);
  const Exported exported(lamp, {});
  CHECK(exported.text == kUrdf);
  CHECK(exported.losses ==
        "SML8002 `diffuseColor` of material `red` differs from the URDF, which is kept; see "
        "--apply materials\n"
        "SML8001 `shininess` of material `red` has no place in a URDF\n"
        "SML8001 `type` of motor `hinge` has no place in a URDF\n"
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
        "SML8001 `type` of motor `again` has no place in a URDF\n"
        "SML8002 `maxEffort` of motor `again` differs from the URDF, which is kept; see --apply "
        "limits\n"
        "SML8002 `springDamping` of joint `hinge` differs from the URDF, which is kept; see "
        "--apply dynamics\n"
        "SML8002 sensor `s` is not written; see --sensors gazebo\n"
        "SML8001 `battery` has no place in a URDF\n");
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

TEST_CASE("a link on a fixed joint becomes part of the link that carries it") {
  UrdfExport options;
  options.collapses_fixed = true;
  const Exported collapsed(Read(kUrdf), options);
  CHECK_FALSE(collapsed.has("bulb"));
  CHECK(collapsed.has("<mass value=\"0.75\"/>"));
  CHECK(collapsed.has("    <visual>\n"
                      "      <origin xyz=\"0 0.1 0.2\" rpy=\"0 0 1."));
  // A sensor stands on `eye`, so it stays a link, on the arm now; the shade hangs on the arm too.
  CHECK(collapsed.has("<link name=\"eye\"/>"));
  CHECK(collapsed.has("    <parent link=\"arm\"/>\n    <child link=\"shade\"/>\n"
                      "    <axis xyz=\"1 0 0\"/>\n    <limit effort=\"1\" velocity=\"1\"/>\n"
                      "    <origin xyz=\"0 0.1 0.2\" rpy=\"0 0 1."));
  options.keep = {"mount"};
  CHECK(Exported(Read(kUrdf), options).text == kUrdf);
}

TEST_CASE("the proof finds a mass that went missing on the way") {
  const Read lamp(kUrdf);
  UrdfExport options;
  options.collapses_fixed = true;
  DiagnosticSink sink;
  const std::string text = export_urdf(lamp.model, lamp.sources, options, sink);
  const Read wrong(replaced(text, "<mass value=\"0.75\"/>", "<mass value=\"0.5\"/>"));
  const Proof proof = compare_models(lamp.model, wrong.model, proof_scope(options));
  CHECK(proof.difference == "the total mass differs");
  // Links that move must not vanish.
  CHECK_FALSE(compare_models(lamp.model, Read(replaced(text, "\"shade\"", "\"shape\"")).model,
                             proof_scope(options))
                  .holds());
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

TEST_CASE("motors become extensions where no extension drives their joints") {
  const Read lamp(kUrdf, kAnnotations);
  UrdfExport options;
  options.actuation = Actuation::ros2_control;
  const Exported ros2(lamp, options);
  // The hinge has a transmission; the other motor follows it, so it is not commanded.
  CHECK(ros2.has("  <ros2_control name=\"lamp\" type=\"system\">\n"));
  CHECK(ros2.has("    <joint name=\"tilt\">\n      <state_interface name=\"position\"/>\n"));
  CHECK_FALSE(ros2.has("command_interface"));
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
      "- {name: p, type: JointPosition, id: [hinge]}\n";
  const Exported exported(Read(plain, sensors), options);
  CHECK(exported.has("  <gazebo reference=\"eye\">\n    <sensor name=\"s\" type=\"imu\">\n"
                     "      <update_rate>50</update_rate>\n    </sensor>\n  </gazebo>\n"));
  CHECK(exported.has("<pose>1 2 3 0 0 1.570796"));
  CHECK(exported.has("<horizontal_fov>1.570796"));
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
