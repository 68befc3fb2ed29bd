// SPDX-License-Identifier: BSD-3-Clause
// A lamp, and its export.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "smurf/convert.hpp"
#include "smurf/load.hpp"
#include "support/replaced.hpp"

namespace smurf::test {

inline const std::string kUrdf = R"(<robot name="lamp">
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

inline const std::string kAnnotations = R"(motors:
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
  std::string losses;  ///< "SML8001 message", one per line

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
    // A second export changes nothing, except that prefixes and bases are added again.
    if (!options.prefix.empty() || options.base != BaseJoint::as_is) return;
    CHECK(export_urdf(result.model, result.sources, options, sink) == text);
  }

  bool loses(const std::string& loss) const {
    return losses.find(loss + "\n") != std::string::npos;
  }

  bool has(const std::string& part) const { return text.find(part) != std::string::npos; }
};

/// Two links on fixed joints above a base; the upper one is at (0, 1, 2), rotated about z.
inline std::string tower(const std::string& extensions, const std::string& shape = {}) {
  return R"(<robot name="tower">
  <link name="base"/>
  <link name="floor"/>
  <link name="top">)" +
         shape + R"(</link>
  <joint name="a" type="fixed">
    <origin xyz="0 1 1"/><parent link="base"/><child link="floor"/>
  </joint>
  <joint name="b" type="fixed">
    <origin xyz="0 0 1" rpy="0 0 0.5"/><parent link="floor"/><child link="top"/>
  </joint>
)" + extensions +
         "</robot>\n";
}

}  // namespace smurf::test
