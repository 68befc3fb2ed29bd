// SPDX-License-Identifier: BSD-3-Clause
// Constructs in real models that look like defects but are not: nothing is reported.
#include <doctest/doctest.h>

#include "support/loaded.hpp"
#include "support/replaced.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

/// The robot of all cases: a base, an arm on a movable joint, a tool on a fixed one.
const std::string kUrdf = R"(<robot name="crane">
  <link name="base"/>
  <link name="arm">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <link name="tool"/>
  <joint name="lift" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
  <joint name="flange" type="fixed">
    <parent link="arm"/>
    <child link="tool"/>
  </joint>
</robot>
)";

const std::string kMotor =
    "motors: [{name: lift, joint: lift, type: PID, maxEffort: 10, maxSpeed: 2}]\n";

/// The findings in the robot with this annotation file.
std::vector<std::string> findings(const std::string& annotations, const std::string& urdf = kUrdf) {
  Loaded loaded;
  loaded.files.add("crane.smurf", "modelname: crane\nfiles: [crane.urdf, crane.yml]\n");
  loaded.files.add("crane.urdf", urdf);
  loaded.files.add("crane.yml", annotations);
  loaded.load("crane.smurf");
  return loaded.briefs();
}

const std::vector<std::string> kNothing;

}  // namespace

TEST_CASE("the name of a submechanism is its kind and repeats") {
  CHECK(findings(R"(submechanisms:
- {name: serial, type: serial, contextual_name: left, jointnames: [lift]}
- {name: serial, type: serial, contextual_name: right, jointnames: [lift]}
)") == kNothing);
}

TEST_CASE("joints of a floating base need not be in the URDF") {
  CHECK(findings(R"(submechanisms:
- {name: base, type: serial, contextual_name: base, jointnames: [floating_x, floating_y, lift]}
)") == kNothing);
}

TEST_CASE("a link and a joint of one name are a matter of portability, not of the annotations") {
  const std::string urdf = replaced(kUrdf, R"(joint name="flange")", R"(joint name="tool")");
  for (const std::string& finding :
       findings("sensors: [{name: place, type: NodePosition, id: [tool]}]\n", urdf)) {
    CHECK(finding.starts_with("SML1303"));
  }
}

TEST_CASE("JSON is YAML") {
  CHECK(findings(R"({
  "motors": [
    {"joint": "lift", "maxEffort": 10.0, "maxSpeed": 2.0, "name": "lift", "p": 1e-05, "type": "PID"}
  ],
  "semantics": {"on": true, "no": [1e3]}
})") == kNothing);
}

TEST_CASE("templates of hardware repeat names across kinds") {
  CHECK(findings(R"(templates:
- {type: motor, name: maxon}
- {type: encoder, name: maxon}
- {type: motor, name: maxon}
)") == kNothing);
}

TEST_CASE("a file of type templates that no model lists is no annotation file") {
  Loaded loaded;
  loaded.files.add("hardware.yml", R"(motors:
  maxon: {p: 1.0, ratio: 66}
sensors:
  encoder: {resolution: 4096}
)");
  loaded.load("hardware.yml");
  CHECK(loaded.briefs() == kNothing);
}

TEST_CASE("own keys and sections are normal") {
  CHECK(findings(R"(motors:
- {name: lift, joint: lift, type: PID, maxEffort: 10, maxSpeed: 2, ratio: 66, supplier: maxon,
   maxCurrent: 3.5, bus: {id: 7}}
battery: {cells: 12}
notes: [{name: arm, text: repaint}]
)") == kNothing);
}

TEST_CASE("the joints of a submechanism may be fixed") {
  CHECK(findings(R"(submechanisms:
- {name: serial, type: serial, contextual_name: arm, jointnames: [lift, flange]}
)") == kNothing);
}

TEST_CASE("joints may be passive, and models without motors") {
  CHECK(findings("sensors: [{name: angle, type: JointPosition, id: [lift]}]\n") == kNothing);
}

TEST_CASE("half a file may be comments") {
  CHECK(findings("# motors:\n# - {name: old, joint: gone}\n" + kMotor + "# sensors: [\n") ==
        kNothing);
}

TEST_CASE("a part on its own refers to joints that live elsewhere") {
  Loaded loaded;
  loaded.files.add("leg_motors.yml", R"(motors:
- {name: knee, joint: knee, type: PID, maxEffort: 10, maxSpeed: 2, mimic_motor: other_knee,
   mimic_multiplier: -1}
sensors: [{name: angles, type: JointPosition, id: [knee, hip]}]
)");
  loaded.load("leg_motors.yml");
  CHECK(loaded.briefs() == kNothing);
}
