# SPDX-License-Identifier: BSD-3-Clause
"""One-defect changes of a SMURF model: (name, file, text as it stands, text with the defect, where if not there).

The text as it stands occurs once in the file, or its first occurrence is meant. `where` is a text of the
line that the finding is expected at, for defects that are seen elsewhere than where they are made.
"""

MAIN = "crane/crane.smurf"
URDF = "crane/crane.urdf"
MOTORS = "crane/motors.yml"
SENSORS = "crane/sensors.yml"
LOOKS = "crane/looks.yml"
CONTACTS = "crane/contacts.yml"
JOINTS = "crane/joints.yml"
CONTROL = "crane/control.yml"
POSES = "crane/poses.yml"
MECHANISM = "crane/mechanism.yml"

# Usually one line per entry, so that a finding on an entry is at its line.
FILES = {
    MAIN: """# a crane on rails
modelname: crane
files:
  - crane.urdf
  - motors.yml
  - sensors.yml
  - looks.yml
  - contacts.yml
  - joints.yml
  - control.yml
  - poses.yml
  - mechanism.yml
""",
    URDF: """<?xml version="1.0" encoding="utf-8"?>
<robot name="crane">
  <material name="yellow"><color rgba="0.9 0.8 0.1 1"/></material>
  <material name="steel"><color rgba="0.5 0.5 0.55 1"/></material>
  <link name="base"/>
  <link name="mast">
    <inertial><origin xyz="0 0 0.5"/><mass value="20"/><inertia ixx="1.7" ixy="0" ixz="0" iyy="1.7" iyz="0" izz="0.1"/></inertial>
    <visual name="mast_visual"><origin xyz="0 0 0.5"/><geometry><box size="0.2 0.2 1"/></geometry><material name="yellow"/></visual>
    <collision name="mast_collision"><origin xyz="0 0 0.5"/><geometry><box size="0.2 0.2 1"/></geometry></collision>
  </link>
  <link name="boom">
    <inertial><origin xyz="0.75 0 0"/><mass value="8"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="1.5" iyz="0" izz="1.5"/></inertial>
    <visual name="boom_visual"><origin xyz="0.75 0 0"/><geometry><box size="1.5 0.1 0.1"/></geometry><material name="yellow"/></visual>
    <collision name="boom_collision"><origin xyz="0.75 0 0"/><geometry><box size="1.5 0.1 0.1"/></geometry></collision>
  </link>
  <link name="trolley">
    <inertial><mass value="2"/><inertia ixx="0.004" ixy="0" ixz="0" iyy="0.004" iyz="0" izz="0.004"/></inertial>
    <visual name="trolley_visual"><geometry><box size="0.12 0.12 0.12"/></geometry><material name="steel"/></visual>
    <collision name="trolley_collision"><geometry><box size="0.12 0.12 0.12"/></geometry></collision>
  </link>
  <link name="hook">
    <inertial><mass value="0.5"/><inertia ixx="0.0002" ixy="0" ixz="0" iyy="0.0002" iyz="0" izz="0.0002"/></inertial>
    <visual name="hook_visual"><geometry><sphere radius="0.03"/></geometry><material name="steel"/></visual>
    <collision name="hook_collision"><geometry><sphere radius="0.03"/></geometry></collision>
  </link>
  <link name="fan">
    <inertial><mass value="0.2"/><inertia ixx="0.0002" ixy="0" ixz="0" iyy="0.0002" iyz="0" izz="0.0003"/></inertial>
    <collision name="fan_collision"><geometry><cylinder radius="0.05" length="0.02"/></geometry></collision>
  </link>
  <joint name="foot" type="fixed"><parent link="base"/><child link="mast"/></joint>
  <joint name="slew" type="revolute"><parent link="mast"/><child link="boom"/><origin xyz="0 0 1"/><axis xyz="0 0 1"/><limit lower="-2" upper="2.5" effort="80" velocity="1.5"/></joint>
  <joint name="travel" type="prismatic"><parent link="boom"/><child link="trolley"/><origin xyz="0.2 0 -0.12"/><axis xyz="1 0 0"/><limit lower="0" upper="1.2" effort="200" velocity="0.5"/></joint>
  <joint name="swing" type="revolute"><parent link="trolley"/><child link="hook"/><origin xyz="0 0 -0.3"/><axis xyz="0 1 0"/><limit lower="-0.5" upper="0.8" effort="5" velocity="3"/></joint>
  <joint name="spin" type="continuous"><parent link="mast"/><child link="fan"/><origin xyz="0.12 0 0.3"/><axis xyz="0 0 1"/><limit effort="3" velocity="40"/></joint>
</robot>
""",
    MOTORS: """motors:
  - {name: slew, joint: slew, type: PID, p: 10.0, i: 0.0, d: 0.0, minValue: -2.0, maxValue: 2.5, maxEffort: 80.0, maxSpeed: 1.5}
  - {name: travel, joint: travel, type: PID, p: 20.0, i: 0.1, d: 0.0, minValue: 0.0, maxValue: 1.2, maxEffort: 200.0, maxSpeed: 0.5, filterValue: 0.2}
  - {name: spin, joint: spin, type: DC, minValue: -3.14, maxValue: 3.14, maxEffort: 3.0, maxSpeed: 40.0}
""",
    SENSORS: """sensors:
  - {name: angles, type: JointPosition, link: mast, rate: 10, id: [slew, travel]}
  - {name: speeds, type: JointVelocity, link: mast, rate: 10, id: [slew, travel, spin]}
  - {name: currents, type: MotorCurrent, link: mast, rate: 10, id: [slew, spin]}
  - {name: hook_place, type: NodePosition, link: hook, rate: 10, id: [hook]}
  - {name: imu, type: NodeIMU, link: boom, rate: 10, id: [boom]}
  - {name: bump, type: NodeContact, link: hook, rate: 10, id: [hook_collision]}
  - {name: weight, type: Joint6DOF, link: hook, joint: swing, rate: 10}
  - {name: balance, type: NodeCOM, link: mast, rate: 10, id: [mast, boom, trolley, hook]}
  - {name: camera, type: CameraSensor, link: boom, rate: 50, width: 640, height: 480, opening_width: 70, opening_height: 50, position_offset: {x: 0.1, y: 0.0, z: 0.0}, orientation_offset: {roll: 0.0, pitch: 30.0, yaw: 0.0}}
  - {name: ranger, type: RaySensor, link: mast, rate: 50, width: 11, opening_width: 1.2, max_distance: 20.0, draw_rays: false}
  - {name: lidar, type: RotatingRaySensor, link: mast, rate: 100, bands: 16, lasers: 32, opening_width: 6.2832, opening_height: 0.5, max_distance: 50.0, min_distance: 0.1}
  - {name: grid, type: MultiLevelLaserRangeFinder, link: mast, rate: 100, numRaysVertical: 8, numRaysHorizontal: 16, rttResolutionX: 64, rttResolutionY: 64, verticalOpeningAngle: 0.5, horizontalOpeningAngle: 1.0, maxDistance: 10.0}
  - {name: sonar, type: ScanningSonar, link: mast, rate: 100, resolution: 0.1, gain: 1.0, maxDistance: 40.0, show_cam: false}
""",
    LOOKS: """materials:
  - name: yellow
    ambientColor: {r: 0.4, g: 0.35, b: 0.05, a: 1.0}
    diffuseColor: {r: 0.9, g: 0.8, b: 0.1, a: 1.0}
    specularColor: {r: 0.5, g: 0.5, b: 0.5, a: 1.0}
    shininess: 20.0
  - {name: steel, diffuseColor: {r: 0.5, g: 0.5, b: 0.55, a: 1.0}, transparency: 0.0, tex_scale: 1.0}
visuals:
  - {name: boom_visual, materialName: yellow, shadowcaster: true}
graphics:
  - {clearColor: {r: 0.6, g: 0.7, b: 0.9, a: 1.0}, fogEnabled: true, fogDensity: 0.3, fogStart: 10.0, fogEnd: 40.0, fogColor: {r: 0.6, g: 0.7, b: 0.9, a: 1.0}}
lights:
  - {name: lamp, type: 2, directional: false, position: {x: 0.0, y: 0.0, z: 3.0}, lookat: {x: 0.0, y: 0.0, z: 0.0}, angle: 40.0, exponent: 2.0, ambient: {r: 0.1, g: 0.1, b: 0.1, a: 1.0}, diffuse: {r: 0.8, g: 0.8, b: 0.8, a: 1.0}, specular: {r: 0.4, g: 0.4, b: 0.4, a: 1.0}, constantAttenuation: 1.0, linearAttenuation: 0.0, quadraticAttenuation: 0.01}
""",
    CONTACTS: """collision:
  - {name: mast_collision, link: mast, bitmask: 65535, cfriction1: 0.9, cfriction2: 0.9}
  - {name: boom_collision, link: boom, bitmask: 65535}
  - {name: hook_collision, link: hook, bitmask: 65535, cmax_num_contacts: 4, ccfm: 1.0e-08, cerp: 0.2}
link:
  - {name: boom, link: boom, linear_damping: 0.02, angular_damping: 0.02}
  - {name: mast, link: mast, linear_damping: 0.01, angular_damping: 0.01}
nodes:
  - {name: sign, parent: mast, physicmode: box, noPhysical: true, extend: {x: 0.2, y: 0.01, z: 0.1}, position: {x: 0.0, y: 0.12, z: 0.8}, rotation: {w: 1.0, x: 0.0, y: 0.0, z: 0.0}, materialName: yellow}
""",
    JOINTS: """joint:
  - {name: swing, spring_const_constraint_axis1: 4.0, damping_const_constraint_axis1: 0.4, springStiffness: 4.0, springDamping: 0.4, anchorpos: node2}
joint_tasks:
  - {name: slew, provider: frames, port: slew, driver: crane}
  - {name: travel, provider: frames, port: travel, driver: crane}
  - {name: swing, provider: frames, port: swing, driver: unnamed}
  - {name: spin, provider: frames, port: spin, driver: unnamed}
""",
    CONTROL: """controllers:
  - {name: pilot, rate: 20, sensors: [angles, speeds, weight], motors: [slew, travel]}
""",
    POSES: """poses:
  - {name: parked, joints: {slew: 0.0, travel: 0.0}}
  - {name: loading, joints: {slew: 1.2, travel: 0.8}}
""",
    MECHANISM: """submechanisms:
  - name: serial_chain
    contextual_name: gantry
    type: serial
    jointnames: [slew, travel]
    jointnames_spanningtree: [slew, travel]
    jointnames_active: [slew, travel]
    jointnames_independent: [slew, travel]
interfaces:
  - {name: hitch, parent: hook, type: hook, direction: outward, position: [0.0, 0.0, -0.03], rotation: [0.0, 0.0, 0.0]}
""",
}

MUTANTS = [
    # The main file.
    ("main-urdf-missing", MAIN, "- crane.urdf", "- crain.urdf"),
    ("main-yml-missing", MAIN, "- motors.yml", "- motor.yml"),
    ("main-yaml-ending", MAIN, "- motors.yml", "- motors.yaml"),
    ("main-wrong-case", MAIN, "- motors.yml", "- Motors.yml"),
    ("main-upper-case-ending", MAIN, "- motors.yml", "- motors.YML"),
    ("main-no-urdf", MAIN, "  - crane.urdf\n", "", "files:"),
    ("main-urdf-twice", MAIN, "  - motors.yml", "  - crane.urdf\n  - motors.yml"),
    ("main-listed-twice", MAIN, "  - sensors.yml", "  - motors.yml\n  - sensors.yml"),
    ("main-listed-twice-otherwise", MAIN, "  - sensors.yml", "  - ./motors.yml\n  - sensors.yml"),
    ("main-backslash", MAIN, "- motors.yml", "- .\\motors.yml"),
    ("main-absolute", MAIN, "- motors.yml", "- /home/ann/crane/motors.yml"),
    ("main-file-scheme", MAIN, "- crane.urdf", "- file://crane.urdf"),
    ("main-package", MAIN, "- crane.urdf", "- package://crane/crane.urdf"),
    ("main-variable", MAIN, "- motors.yml", "- $HOME/motors.yml"),
    ("main-folder", MAIN, "- motors.yml", "- ."),
    ("main-lists-a-smurf", MAIN, "- motors.yml", "- crane.smurf"),
    ("main-lists-a-mesh", MAIN, "- motors.yml", "- motors.stl"),
    ("main-xacro", MAIN, "- crane.urdf", "- crane.urdf.xacro"),
    ("main-sdf", MAIN, "- crane.urdf", "- crane.sdf"),
    ("main-files-misspelt", MAIN, "files:", "flies:"),
    ("main-files-case", MAIN, "files:", "Files:"),
    ("main-files-map", MAIN, "files:\n  - crane.urdf\n", "files:\n  urdf: crane.urdf\nmore:\n"),
    ("main-files-empty", MAIN, "files:", "files: []\nothers:"),
    ("main-file-empty-text", MAIN, "- motors.yml", "- ''"),
    ("main-file-null", MAIN, "- motors.yml", "- "),
    ("main-file-a-map", MAIN, "- motors.yml", "- motors: motors.yml"),
    ("main-file-a-number", MAIN, "- motors.yml", "- 12"),
    ("main-name-misspelt", MAIN, "modelname:", "modelnam:"),
    ("main-name-other-style", MAIN, "modelname:", "model_name:"),
    ("main-name-list", MAIN, "modelname: crane", "modelname: [crane]"),
    ("main-name-empty", MAIN, "modelname: crane", "modelname: ''"),
    ("main-name-null", MAIN, "modelname: crane", "modelname:"),
    ("main-name-missing", MAIN, "modelname: crane\n", ""),
    ("main-duplicate-files", MAIN, "files:", "files: [crane.urdf]\nfiles:"),
    ("main-indent", MAIN, "  - sensors.yml", "   - sensors.yml"),
    ("main-no-blank", MAIN, "  - sensors.yml", "  -sensors.yml"),
    ("main-colon-missing", MAIN, "modelname: crane", "modelname crane"),
    ("main-colon-no-blank", MAIN, "modelname: crane", "modelname:crane"),
    ("main-unclosed", MAIN, "modelname: crane", 'modelname: "crane'),
    ("main-root-list", MAIN, "modelname: crane\nfiles:\n", "- modelname: crane\n- files:\n"),
    ("main-uri", MAIN, "modelname: crane", "modelname: crane\nURI: other.yml"),
    ("main-order", MAIN, "  - motors.yml\n  - sensors.yml", "  - control.yml\n  - motors.yml\n  - sensors.yml", "- control.yml"),
    ("main-conflict-marker", MAIN, "  - sensors.yml", "<<<<<<< HEAD\n  - sensors.yml"),
    # Annotation files as a whole.
    ("section-scalar", MOTORS, "motors:", "version: 1\nmotors:"),
    ("section-autogenerated", MOTORS, "motors:", "_autogenerated: true\nmotors:"),
    ("section-modelname", SENSORS, "sensors:", "modelname: crane\nsensors:"),
    ("section-files", SENSORS, "sensors:", "files: [more.yml]\nsensors:"),
    ("section-misspelt", SENSORS, "sensors:", "sesnors:"),
    ("section-case", SENSORS, "sensors:", "Sensors:"),
    ("section-singular", SENSORS, "sensors:", "sensor:"),
    ("section-collisions", CONTACTS, "collision:", "collisions:"),
    ("section-links", CONTACTS, "\nlink:", "\nlinks:"),
    ("section-node", CONTACTS, "nodes:", "node:"),
    ("section-joints", JOINTS, "joint:", "joints:"),
    ("section-controller", CONTROL, "controllers:", "controller:"),
    ("section-pose", POSES, "poses:", "pose:"),
    ("section-material", LOOKS, "materials:", "matrials:"),
    ("section-light", LOOKS, "\nlights:", "\nlight:"),
    ("section-visual", LOOKS, "\nvisuals:", "\nvisual:"),
    ("section-twice", POSES, "poses:\n", "poses: []\nposes:\n"),
    ("section-text", POSES, "poses:\n", "poses: none\nother:\n"),
    ("section-number-entry", MOTORS, "motors:\n", "motors:\n  - slew\n"),
    ("section-map-shape", CONTROL, "controllers:\n  - {", "controllers:\n  pilot: {"),
    ("section-empty-file", POSES, 'poses:\n  - {name: parked, joints: {slew: 0.0, travel: 0.0}}\n  - {name: loading, joints: {slew: 1.2, travel: 0.8}}\n', ""),
    ("section-null-entry", MOTORS, "motors:\n", "motors:\n  -\n"),
    ("section-tab", MOTORS, "  - {name: travel", "\t- {name: travel"),
    ("section-brace", MOTORS, "maxSpeed: 1.5}", "maxSpeed: 1.5"),
    ("section-merge-key", MOTORS, "name: travel,", "<<: {p: 1.0}, name: travel,"),
    ("section-unknown-alias", MOTORS, "p: 20.0", "p: *gain"),
    ("section-duplicate-key", MOTORS, "p: 20.0", "p: 20.0, p: 30.0"),
    # Motors.
    ("motor-no-name", MOTORS, "{name: slew, joint", "{joint"),
    ("motor-name-null", MOTORS, "{name: slew,", "{name: ,"),
    ("motor-name-empty", MOTORS, "{name: slew,", "{name: '',"),
    ("motor-no-joint", MOTORS, " joint: slew,", ""),
    ("motor-joint-unknown", MOTORS, "joint: travel", "joint: travl"),
    ("motor-joint-case", MOTORS, "joint: travel", "joint: Travel"),
    ("motor-joint-a-link", MOTORS, "joint: travel", "joint: trolley"),
    ("motor-joint-fixed", MOTORS, "joint: travel", "joint: foot"),
    ("motor-joint-shared", MOTORS, "joint: travel", "joint: slew"),
    ("motor-joint-list", MOTORS, "joint: travel", "joint: [travel]"),
    ("motor-joint-quoted-blank", MOTORS, "joint: travel", "joint: 'travel '"),
    ("motor-type-lower", MOTORS, "type: PID", "type: pid"),
    ("motor-type-unknown", MOTORS, "type: DC", "type: AC"),
    ("motor-type-upper", MOTORS, "type: DC", "type: VELOCITY"),
    ("motor-type-missing", MOTORS, " type: DC,", ""),
    ("motor-type-number", MOTORS, "type: DC", "type: 3"),
    ("motor-no-effort", MOTORS, " maxEffort: 200.0,", ""),
    ("motor-no-speed", MOTORS, ", maxSpeed: 1.5", ""),
    ("motor-effort-zero", MOTORS, "maxEffort: 200.0", "maxEffort: 0"),
    ("motor-effort-negative", MOTORS, "maxEffort: 200.0", "maxEffort: -200.0"),
    ("motor-speed-negative", MOTORS, "maxSpeed: 1.5", "maxSpeed: -1.5"),
    ("motor-effort-unit", MOTORS, "maxEffort: 200.0", "maxEffort: 200 N"),
    ("motor-effort-text", MOTORS, "maxEffort: 200.0", "maxEffort: high"),
    ("motor-effort-quoted", MOTORS, "maxEffort: 200.0", "maxEffort: '200.0'"),
    ("motor-effort-null", MOTORS, "maxEffort: 200.0", "maxEffort: "),
    ("motor-effort-list", MOTORS, "maxEffort: 200.0", "maxEffort: [200.0]"),
    ("motor-effort-inf", MOTORS, "maxEffort: 200.0", "maxEffort: .inf"),
    ("motor-effort-nan", MOTORS, "maxEffort: 200.0", "maxEffort: .nan"),
    ("motor-effort-comma", MOTORS, "maxEffort: 200.0", "maxEffort: '200,0'"),
    ("motor-effort-underscore", MOTORS, "maxEffort: 200.0", "maxEffort: 1_000"),
    ("motor-effort-exponent", MOTORS, "maxEffort: 200.0", "maxEffort: 2e2"),
    ("motor-effort-other-than-joint", MOTORS, "maxEffort: 200.0", "maxEffort: 250.0"),
    ("motor-effort-thousand", MOTORS, "maxEffort: 200.0", "maxEffort: 200000.0"),
    ("motor-speed-beyond-joint", MOTORS, "maxSpeed: 1.5", "maxSpeed: 15.0"),
    ("motor-speed-degrees", MOTORS, "maxSpeed: 1.5", "maxSpeed: 86.0"),
    ("motor-bounds-swapped", MOTORS, "minValue: -2.0, maxValue: 2.5", "minValue: 2.5, maxValue: -2.0"),
    ("motor-bounds-equal", MOTORS, "minValue: -2.0, maxValue: 2.5", "minValue: 2.5, maxValue: 2.5"),
    ("motor-bound-beyond", MOTORS, "maxValue: 2.5", "maxValue: 3.1"),
    ("motor-bound-below", MOTORS, "minValue: -2.0", "minValue: -2.4"),
    ("motor-bounds-degrees", MOTORS, "minValue: -2.0, maxValue: 2.5", "minValue: -114.6, maxValue: 143.2"),
    ("motor-bound-degrees", MOTORS, "maxValue: 2.5", "maxValue: 143.2"),
    ("motor-bounds-absent", MOTORS, " minValue: -2.0, maxValue: 2.5,", ""),
    ("motor-bound-absent", MOTORS, " maxValue: 2.5,", ""),
    ("motor-bounds-millimetres", MOTORS, "maxValue: 1.2", "maxValue: 1200"),
    ("motor-bound-new-name", MOTORS, "maxValue: 2.5", "maxValue: 2.5, maxPosition: 3.0"),
    ("motor-p-text", MOTORS, "p: 20.0", "p: high"),
    ("motor-p-negative", MOTORS, "p: 20.0", "p: -20.0"),
    ("motor-p-missing", MOTORS, " p: 20.0,", ""),
    ("motor-p-zero", MOTORS, "p: 20.0, i: 0.1", "p: 0.0, i: 0.0"),
    ("motor-gains-upper", MOTORS, "p: 20.0", "P: 20.0"),
    ("motor-filter-above-one", MOTORS, "filterValue: 0.2", "filterValue: 2.0"),
    ("motor-effort-misspelt", MOTORS, "maxEffort: 200.0", "maxEfort: 200.0"),
    ("motor-effort-style", MOTORS, "maxEffort: 200.0", "max_effort: 200.0"),
    ("motor-effort-case", MOTORS, "maxEffort: 200.0", "maxeffort: 200.0"),
    ("motor-effort-urdf-name", MOTORS, "maxEffort: 200.0", "effort: 200.0"),
    ("motor-speed-urdf-name", MOTORS, "maxSpeed: 0.5", "velocity: 0.5"),
    ("motor-speed-other-name", MOTORS, "maxSpeed: 0.5", "maxVelocity: 0.5"),
    ("motor-bound-misspelt", MOTORS, "minValue: -2.0", "minVale: -2.0"),
    ("motor-mimic-unknown", MOTORS, "filterValue: 0.2", "mimic_motor: slow, mimic_multiplier: 1.0"),
    ("motor-mimic-no-factor", MOTORS, "filterValue: 0.2", "mimic_motor: slew"),
    ("motor-mimic-itself", MOTORS, "filterValue: 0.2", "mimic_motor: travel, mimic_multiplier: 1.0"),
    ("motor-mimic-a-joint", MOTORS, "filterValue: 0.2", "mimic_motor: swing, mimic_multiplier: 1.0"),
    ("motor-mimic-zero", MOTORS, "filterValue: 0.2", "mimic_motor: slew, mimic_multiplier: 0.0"),
    ("motor-mimic-by-speed", MOTORS, "filterValue: 0.2", "mimic_motor: spin, mimic_multiplier: 2.0"),
    ("motor-mimic-text", MOTORS, "filterValue: 0.2", "mimic_motor: slew, mimic_multiplier: twice"),
    ("motor-mimic-without-leader", MOTORS, "filterValue: 0.2", "mimic_multiplier: 2.0"),
    ("motor-mimic-camel", MOTORS, "filterValue: 0.2", "mimicMotor: slew, mimic_multiplier: 2.0"),
    ("motor-duplicate-name", MOTORS, "{name: travel,", "{name: slew,"),
    ("motor-approximation", MOTORS, "filterValue: 0.2", "maxeffort_approximation: polynom3, maxeffort_coefficients: [1.0, 2.0]"),
    ("motor-approximation-unknown", MOTORS, "filterValue: 0.2", "maxeffort_approximation: polynomial, maxeffort_coefficients: [1.0, 2.0]"),
    ("motor-approximation-alone", MOTORS, "filterValue: 0.2", "maxspeed_approximation: polynom2"),
    ("motor-boolean", MOTORS, "filterValue: 0.2", "noDataPackage: yes"),
    ("motor-boolean-quoted", MOTORS, "filterValue: 0.2", "maxEffortControl: 'true'"),
    ("motor-position-without-effect", MOTORS, "filterValue: 0.2", "positon: 0.3"),
    # Sensors.
    ("sensor-no-name", SENSORS, "{name: imu, type", "{type"),
    ("sensor-no-type", SENSORS, "{name: imu, type: NodeIMU,", "{name: imu,"),
    ("sensor-type-misspelt", SENSORS, "type: NodeIMU", "type: NodeIMUU"),
    ("sensor-type-case", SENSORS, "type: NodeIMU", "type: nodeIMU"),
    ("sensor-type-urdf", SENSORS, "type: CameraSensor", "type: camera"),
    ("sensor-type-phobos", SENSORS, "type: NodeIMU", "type: IMU"),
    ("sensor-type-gps", SENSORS, "type: NodeIMU", "type: GPS"),
    ("sensor-type-list", SENSORS, "type: NodeIMU", "type: [NodeIMU]"),
    ("sensor-duplicate", SENSORS, "{name: speeds,", "{name: angles,"),
    ("sensor-link-unknown", SENSORS, "type: NodeIMU, link: boom", "type: NodeIMU, link: bom"),
    ("sensor-link-a-joint", SENSORS, "type: NodeIMU, link: boom", "type: NodeIMU, link: slew"),
    ("sensor-link-missing", SENSORS, "type: CameraSensor, link: boom,", "type: CameraSensor,"),
    ("sensor-link-list", SENSORS, "type: CameraSensor, link: boom,", "type: CameraSensor, link: [boom],"),
    ("sensor-link-misspelt-key", SENSORS, "type: CameraSensor, link: boom,", "type: CameraSensor, lnik: boom,"),
    ("sensor-id-unknown", SENSORS, "id: [slew, travel]", "id: [slew, travle]"),
    ("sensor-id-a-link", SENSORS, "id: [slew, travel]", "id: [slew, trolley]"),
    ("sensor-id-twice", SENSORS, "id: [slew, travel]", "id: [slew, slew]"),
    ("sensor-id-empty", SENSORS, "id: [slew, travel]", "id: []"),
    ("sensor-id-missing", SENSORS, ", id: [slew, travel]", ""),
    ("sensor-id-text", SENSORS, "id: [slew, travel]", "id: slew"),
    ("sensor-id-numbers", SENSORS, "id: [slew, travel]", "id: [1, 2]"),
    ("sensor-ids", SENSORS, "id: [slew, travel]", "ids: [slew, travel]"),
    ("sensor-joints-of-node", SENSORS, "rate: 10, id: [boom]", "rate: 10, joints: [slew]"),
    ("sensor-links-of-joint", SENSORS, "rate: 10, id: [slew, travel]", "rate: 10, links: [boom]"),
    ("sensor-motor-is-a-joint", SENSORS, "id: [slew, spin]", "id: [slew, swing]"),
    ("sensor-contact-of-link", SENSORS, "id: [hook_collision]", "id: [hook]"),
    ("sensor-contact-of-visual", SENSORS, "id: [hook_collision]", "id: [hook_visual]"),
    ("sensor-contact-unknown", SENSORS, "id: [hook_collision]", "id: [hook_colision]"),
    ("sensor-node-unknown", SENSORS, "id: [mast, boom, trolley, hook]", "id: [mast, boom, troley, hook]"),
    ("sensor-6dof-root", SENSORS, "type: Joint6DOF, link: hook", "type: Joint6DOF, link: base"),
    ("sensor-6dof-unknown", SENSORS, "type: Joint6DOF, link: hook", "type: Joint6DOF, link: hok"),
    ("sensor-6dof-no-link", SENSORS, "type: Joint6DOF, link: hook,", "type: Joint6DOF,"),
    ("sensor-6dof-other-joint", SENSORS, "joint: swing", "joint: slew"),
    ("sensor-6dof-joint-unknown", SENSORS, "joint: swing", "joint: swng"),
    ("sensor-rate-negative", SENSORS, "link: boom, rate: 10", "link: boom, rate: -10"),
    ("sensor-rate-fraction", SENSORS, "link: boom, rate: 10", "link: boom, rate: 0.01"),
    ("sensor-rate-half", SENSORS, "link: boom, rate: 10", "link: boom, rate: 2.5"),
    ("sensor-rate-text", SENSORS, "link: boom, rate: 10", "link: boom, rate: 10ms"),
    ("sensor-rate-hz", SENSORS, "link: boom, rate: 10", "link: boom, rate: 100 Hz"),
    ("sensor-rate-misspelt", SENSORS, "link: boom, rate: 10", "link: boom, rte: 10"),
    ("sensor-rate-exponent", SENSORS, "link: boom, rate: 10", "link: boom, rate: 1e1"),
    ("camera-width-zero", SENSORS, "width: 640", "width: 0"),
    ("camera-width-negative", SENSORS, "width: 640", "width: -640"),
    ("camera-width-fraction", SENSORS, "width: 640", "width: 640.5"),
    ("camera-width-text", SENSORS, "width: 640", "width: wide"),
    ("camera-height-zero", SENSORS, "height: 480", "height: 0"),
    ("camera-height-misspelt", SENSORS, "height: 480", "heigth: 480"),
    ("camera-opening-radians", SENSORS, "opening_width: 70", "opening_width: 1.22"),
    ("camera-opening-zero", SENSORS, "opening_width: 70", "opening_width: 0"),
    ("camera-opening-large", SENSORS, "opening_width: 70", "opening_width: 270"),
    ("camera-opening-negative", SENSORS, "opening_width: 70", "opening_width: -70"),
    ("camera-offset-list", SENSORS, "position_offset: {x: 0.1, y: 0.0, z: 0.0}", "position_offset: [0.1, 0.0, 0.0]"),
    ("camera-offset-text", SENSORS, "position_offset: {x: 0.1, y: 0.0, z: 0.0}", "position_offset: {x: a, y: 0.0, z: 0.0}"),
    ("camera-offset-misspelt", SENSORS, "position_offset:", "position_ofset:"),
    ("camera-offset-component", SENSORS, "position_offset: {x: 0.1,", "position_offset: {X: 0.1,"),
    ("camera-orientation-list", SENSORS, "orientation_offset: {roll: 0.0, pitch: 30.0, yaw: 0.0}", "orientation_offset: [0.0, 30.0, 0.0]"),
    ("camera-orientation-radians", SENSORS, "pitch: 30.0", "pitch: 0.5235987755982988"),
    ("camera-orientation-component", SENSORS, "pitch: 30.0", "ptich: 30.0"),
    ("camera-orientation-mixed", SENSORS, "orientation_offset: {roll: 0.0,", "orientation_offset: {w: 1.0,"),
    ("camera-quaternion", SENSORS, "orientation_offset: {roll: 0.0, pitch: 30.0, yaw: 0.0}", "orientation_offset: {w: 2.0, x: 0.0, y: 0.0, z: 0.0}"),
    ("camera-quaternion-zero", SENSORS, "orientation_offset: {roll: 0.0, pitch: 30.0, yaw: 0.0}", "orientation_offset: {w: 0.0, x: 0.0, y: 0.0, z: 0.0}"),
    ("camera-quaternion-part", SENSORS, "orientation_offset: {roll: 0.0, pitch: 30.0, yaw: 0.0}", "orientation_offset: {x: 0.7071, y: 0.0, z: 0.7071}"),
    ("ray-opening-degrees", SENSORS, "opening_width: 1.2", "opening_width: 68.75"),
    ("ray-distance-zero", SENSORS, "max_distance: 20.0", "max_distance: 0"),
    ("ray-distance-negative", SENSORS, "max_distance: 20.0", "max_distance: -20.0"),
    ("ray-width-zero", SENSORS, "width: 11", "width: 0"),
    ("ray-bool", SENSORS, "draw_rays: false", "draw_rays: off"),
    ("ray-key-unread", SENSORS, "draw_rays: false", "drawrays: false"),
    ("lidar-swapped", SENSORS, "min_distance: 0.1", "min_distance: 100.0"),
    ("lidar-min-negative", SENSORS, "min_distance: 0.1", "min_distance: -0.1"),
    ("lidar-opening-degrees", SENSORS, "opening_width: 6.2832", "opening_width: 360"),
    ("lidar-height-degrees", SENSORS, "opening_height: 0.5", "opening_height: 30.0"),
    ("lidar-bands-zero", SENSORS, "bands: 16", "bands: 0"),
    ("lidar-bands-fraction", SENSORS, "bands: 16", "bands: 1.5"),
    ("lidar-lasers-negative", SENSORS, "lasers: 32", "lasers: -32"),
    ("grid-angle-degrees", SENSORS, "verticalOpeningAngle: 0.5", "verticalOpeningAngle: 30.0"),
    ("grid-rays-zero", SENSORS, "numRaysVertical: 8", "numRaysVertical: 0"),
    ("sonar-show", SENSORS, "show_cam: false", "show_cam: true"),
    ("sonar-resolution", SENSORS, "resolution: 0.1", "resolution: -0.1"),
    # Materials, visuals, graphics, lights.
    ("material-unknown", LOOKS, "name: yellow", "name: yelow"),
    ("material-no-name", LOOKS, "{name: steel, diffuseColor", "{diffuseColor"),
    ("material-twice", LOOKS, "{name: steel,", "{name: yellow,"),
    ("material-list", LOOKS, "diffuseColor: {r: 0.9, g: 0.8, b: 0.1, a: 1.0}", "diffuseColor: [0.9, 0.8, 0.1, 1.0]"),
    ("material-text", LOOKS, "diffuseColor: {r: 0.9, g: 0.8, b: 0.1, a: 1.0}", "diffuseColor: 0.9 0.8 0.1 1"),
    ("material-hex", LOOKS, "diffuseColor: {r: 0.9, g: 0.8, b: 0.1, a: 1.0}", "diffuseColor: '#e6cc1a'"),
    ("material-255", LOOKS, "diffuseColor: {r: 0.9, g: 0.8, b: 0.1, a: 1.0}", "diffuseColor: {r: 230, g: 204, b: 26, a: 255}"),
    ("material-component-255", LOOKS, "diffuseColor: {r: 0.9,", "diffuseColor: {r: 230,"),
    ("material-negative", LOOKS, "diffuseColor: {r: 0.9,", "diffuseColor: {r: -0.9,"),
    ("material-component-text", LOOKS, "diffuseColor: {r: 0.9,", "diffuseColor: {r: red,"),
    ("material-component-name", LOOKS, "diffuseColor: {r: 0.9,", "diffuseColor: {red: 0.9,"),
    ("material-component-missing", LOOKS, "diffuseColor: {r: 0.9, g: 0.8,", "diffuseColor: {r: 0.9,"),
    ("material-alpha-missing", LOOKS, "diffuseColor: {r: 0.9, g: 0.8, b: 0.1, a: 1.0}", "diffuseColor: {r: 0.9, g: 0.8, b: 0.1}"),
    ("material-key", LOOKS, "specularColor:", "specularColour:"),
    ("material-key-style", LOOKS, "specularColor:", "specular_color:"),
    ("material-shininess-negative", LOOKS, "shininess: 20.0", "shininess: -20.0"),
    ("material-shininess-text", LOOKS, "shininess: 20.0", "shininess: shiny"),
    ("material-transparency", LOOKS, "transparency: 0.0", "transparency: 80"),
    ("material-texture", LOOKS, "transparency: 0.0", "diffuseTexture: textures/steel.png"),
    ("material-texture-absolute", LOOKS, "transparency: 0.0", "diffuseTexture: /home/ann/steel.png"),
    ("material-scale-text", LOOKS, "tex_scale: 1.0", "tex_scale: big"),
    ("material-reflect", LOOKS, "tex_scale: 1.0", "reflect: no"),
    ("visual-unknown", LOOKS, "name: boom_visual", "name: boom_visul"),
    ("visual-a-link", LOOKS, "name: boom_visual", "name: boom"),
    ("visual-a-collision", LOOKS, "name: boom_visual", "name: boom_collision"),
    ("visual-material", LOOKS, "materialName: yellow", "materialName: yelow"),
    ("visual-bool", LOOKS, "shadowcaster: true", "shadowcaster: on"),
    ("visual-key", LOOKS, "materialName: yellow", "materialname: yellow"),
    ("graphics-fog-swapped", LOOKS, "fogStart: 10.0, fogEnd: 40.0", "fogStart: 40.0, fogEnd: 10.0"),
    ("graphics-fog-negative", LOOKS, "fogDensity: 0.3", "fogDensity: -0.3"),
    ("graphics-fog-bool", LOOKS, "fogEnabled: true", "fogEnabled: yes"),
    ("graphics-fog-misspelt", LOOKS, "fogEnabled: true", "fogEnable: true"),
    ("graphics-colour-list", LOOKS, "clearColor: {r: 0.6, g: 0.7, b: 0.9, a: 1.0}", "clearColor: [0.6, 0.7, 0.9, 1.0]"),
    ("graphics-colour-255", LOOKS, "fogColor: {r: 0.6,", "fogColor: {r: 153,"),
    ("light-type-text", LOOKS, "type: 2", "type: spot"),
    ("light-type-range", LOOKS, "type: 2", "type: 3"),
    ("light-position-list", LOOKS, "position: {x: 0.0, y: 0.0, z: 3.0}", "position: [0.0, 0.0, 3.0]"),
    ("light-colour-255", LOOKS, "diffuse: {r: 0.8,", "diffuse: {r: 204,"),
    ("light-attenuation-negative", LOOKS, "constantAttenuation: 1.0", "constantAttenuation: -1.0"),
    ("light-attenuation-missing", LOOKS, ", linearAttenuation: 0.0", ""),
    ("light-attenuation-misspelt", LOOKS, "linearAttenuation: 0.0", "linearAtenuation: 0.0"),
    ("light-no-type", LOOKS, " type: 2,", ""),
    ("light-angle-text", LOOKS, "angle: 40.0", "angle: 40deg"),
    ("light-angle-large", LOOKS, "angle: 40.0", "angle: 400.0"),
    ("light-exponent-negative", LOOKS, "exponent: 2.0", "exponent: -2.0"),
    ("light-directional-text", LOOKS, "directional: false", "directional: no"),
    ("light-node-unknown", LOOKS, "directional: false", "directional: false, nodeName: bom"),
    # Collisions, links, nodes, joints.
    ("collision-unknown", CONTACTS, "name: boom_collision", "name: bom_collision"),
    ("collision-a-visual", CONTACTS, "name: boom_collision", "name: boom_visual"),
    ("collision-a-link", CONTACTS, "name: boom_collision", "name: boom"),
    ("collision-no-name", CONTACTS, "{name: boom_collision, link", "{link"),
    ("collision-twice", CONTACTS, "{name: boom_collision, link: boom", "{name: mast_collision, link: mast"),
    ("collision-link-unknown", CONTACTS, "link: boom, bitmask", "link: bom, bitmask"),
    ("collision-link-other", CONTACTS, "link: boom, bitmask", "link: mast, bitmask"),
    ("collision-mask-zero", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmask: 0"),
    ("collision-mask-one", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmask: 1"),
    ("collision-mask-large", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmask: 65536"),
    ("collision-mask-huge", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmask: 4294967295"),
    ("collision-mask-hex", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmask: 0xffff"),
    ("collision-mask-fraction", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmask: 1.5"),
    ("collision-mask-text", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmask: all"),
    ("collision-mask-list", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmask: [0, 15]"),
    ("collision-mask-misspelt", CONTACTS, "link: boom, bitmask: 65535", "link: boom, bitmak: 65535"),
    ("collision-friction-negative", CONTACTS, "cfriction1: 0.9", "cfriction1: -0.9"),
    ("collision-friction-text", CONTACTS, "cfriction1: 0.9", "cfriction1: rough"),
    ("collision-friction-misspelt", CONTACTS, "cfriction1: 0.9", "cfricton1: 0.9"),
    ("collision-contacts-negative", CONTACTS, "cmax_num_contacts: 4", "cmax_num_contacts: -4"),
    ("collision-contacts-zero", CONTACTS, "cmax_num_contacts: 4", "cmax_num_contacts: 0"),
    ("collision-contacts-fraction", CONTACTS, "cmax_num_contacts: 4", "cmax_num_contacts: 4.5"),
    ("collision-erp-large", CONTACTS, "cerp: 0.2", "cerp: 2.0"),
    ("collision-cfm-negative", CONTACTS, "ccfm: 1.0e-08", "ccfm: -1.0e-08"),
    ("collision-cfm-notation", CONTACTS, "ccfm: 1.0e-08", "ccfm: 1e-8"),
    ("collision-physicmode", CONTACTS, "cerp: 0.2", "physicmode: ball"),
    ("collision-bounce", CONTACTS, "cerp: 0.2", "cbounce: 2.0"),
    ("collision-extend-zero", CONTACTS, "cerp: 0.2", "extend: {x: 0.0, y: 0.1, z: 0.1}"),
    ("collision-link-missing", CONTACTS, "{name: boom_collision, link: boom, bitmask: 65535}", "{name: boom_collision, bitmask: 65535}"),
    ("collision-mask-missing", CONTACTS, "{name: boom_collision, link: boom, bitmask: 65535}", "{name: boom_collision, link: boom}"),
    ("link-no-link", CONTACTS, "{name: mast, link: mast, linear", "{name: mast, linear"),
    ("link-unknown", CONTACTS, "{name: boom, link: boom, linear", "{name: bom, link: bom, linear"),
    ("link-names-two", CONTACTS, "{name: boom, link: boom, linear", "{name: boom, link: mast, linear"),
    ("link-a-joint", CONTACTS, "{name: boom, link: boom, linear", "{name: slew, link: slew, linear"),
    ("link-damping-negative", CONTACTS, "linear_damping: 0.02", "linear_damping: -0.02"),
    ("link-damping-misspelt", CONTACTS, "linear_damping: 0.02", "linear_dampin: 0.02"),
    ("link-no-name", CONTACTS, "{name: boom, link: boom, linear", "{link: boom, linear"),
    ("node-parent", CONTACTS, "parent: mast", "parent: mst"),
    ("node-mode", CONTACTS, "physicmode: box", "physicmode: bix"),
    ("node-mode-case", CONTACTS, "physicmode: box", "physicmode: Box"),
    ("node-extend-list", CONTACTS, "extend: {x: 0.2, y: 0.01, z: 0.1}", "extend: [0.2, 0.01, 0.1]"),
    ("node-extend-negative", CONTACTS, "extend: {x: 0.2,", "extend: {x: -0.2,"),
    ("node-position-list", CONTACTS, "position: {x: 0.0, y: 0.12, z: 0.8}", "position: [0.0, 0.12, 0.8]"),
    ("node-rotation-list", CONTACTS, "rotation: {w: 1.0, x: 0.0, y: 0.0, z: 0.0}", "rotation: [1.0, 0.0, 0.0, 0.0]"),
    ("node-rotation-not-unit", CONTACTS, "rotation: {w: 1.0,", "rotation: {w: 3.0,"),
    ("node-rotation-zero", CONTACTS, "rotation: {w: 1.0,", "rotation: {w: 0.0,"),
    ("node-rotation-euler", CONTACTS, "rotation: {w: 1.0, x: 0.0, y: 0.0, z: 0.0}", "rotation: {x: 0.0, y: 0.0, z: 90.0}"),
    ("node-material", CONTACTS, "materialName: yellow", "materialName: green"),
    ("node-name-missing", CONTACTS, "{name: sign, parent", "{parent"),
    ("node-viz-link", CONTACTS, "materialName: yellow", "vizLink: mst"),
    ("node-mass-negative", CONTACTS, "materialName: yellow", "mass: -1.0"),
    ("node-inertia", CONTACTS, "noPhysical: true", "mass: 0.3, density: 0, inertia: true, i00: 0.001, i11: 0.001, i22: -0.001"),
    ("node-inertia-mm2", CONTACTS, "noPhysical: true", "mass: 0.3, density: 0, inertia: true, i00: 252.0, i11: 1250.0, i22: 1002.0"),
    ("node-inertia-asymmetric", CONTACTS, "noPhysical: true", "mass: 0.3, density: 0, inertia: true, i00: 0.00025, i01: 0.00001, i11: 0.00125, i22: 0.001"),
    ("node-inertial", CONTACTS, "nodes:\n", "nodes:\n  - {name: inertial_bom, reducedDataPackage: true}\n"),
    ("joint-unknown", JOINTS, "name: swing", "name: swng"),
    ("joint-a-link", JOINTS, "name: swing", "name: hook"),
    ("joint-no-name", JOINTS, "{name: swing, spring", "{spring"),
    ("joint-spring-negative", JOINTS, "spring_const_constraint_axis1: 4.0", "spring_const_constraint_axis1: -4.0"),
    ("joint-spring-text", JOINTS, "spring_const_constraint_axis1: 4.0", "spring_const_constraint_axis1: stiff"),
    ("joint-spring-misspelt", JOINTS, "spring_const_constraint_axis1: 4.0", "spring_const_constrain_axis1: 4.0"),
    ("joint-spring-missing", JOINTS, " springStiffness: 4.0,", ""),
    ("joint-spring-disagrees", JOINTS, "springStiffness: 4.0", "springStiffness: 40.0"),
    ("joint-anchorpos", JOINTS, "anchorpos: node2", "anchorpos: node_2"),
    ("joint-type", JOINTS, "anchorpos: node2", "type: revolute"),
    ("joint-type-misspelt", JOINTS, "anchorpos: node2", "type: hinje"),
    ("joint-axis-list", JOINTS, "anchorpos: node2", "axis1: [0.0, 1.0, 0.0]"),
    ("joint-axis-zero", JOINTS, "anchorpos: node2", "axis1: {x: 0.0, y: 0.0, z: 0.0}"),
    ("joint-stops-swapped", JOINTS, "anchorpos: node2", "lowStopAxis1: 0.5, highStopAxis1: -0.8"),
    ("joint-stops-not-negated", JOINTS, "anchorpos: node2", "lowStopAxis1: -0.5, highStopAxis1: 0.8"),
    ("joint-stops-degrees", JOINTS, "anchorpos: node2", "lowStopAxis1: -45.8, highStopAxis1: 28.6"),
    ("joint-stop-zero", JOINTS, "spring_const_constraint_axis1: 4.0, damping_const_constraint_axis1: 0.4, springStiffness: 4.0, springDamping: 0.4, anchorpos: node2", "lowStopAxis1: 0.0, highStopAxis1: 0.5"),
    ("joint-anchor-list", JOINTS, "anchorpos: node2", "anchorpos: custom, anchor: [0.0, 0.0, 0.0]"),
    ("joint-custom-no-anchor", JOINTS, "anchorpos: node2", "anchorpos: custom"),
    ("joint-bool", JOINTS, "anchorpos: node2", "invertAxis: yes"),
    ("joint-cfm-negative", JOINTS, "anchorpos: node2", "jointCFM: -1.0"),
    ("joint-twice", JOINTS, "joint:\n", "joint:\n  - {name: swing, anchorpos: node1}\n"),
    ("task-missing", JOINTS, "  - {name: spin, provider: frames, port: spin, driver: unnamed}\n", "", "joint_tasks:"),
    ("task-joint", JOINTS, "{name: spin, provider", "{name: boom, provider"),
    ("task-twice", JOINTS, "{name: spin, provider", "{name: swing, provider", "joint_tasks:"),
    ("task-no-port", JOINTS, "provider: frames, port: spin,", "provider: frames,"),
    ("task-key", JOINTS, "driver: unnamed}\n  - {name: spin", "drivr: unnamed}\n  - {name: spin"),
    ("task-driver-null", JOINTS, "port: spin, driver: unnamed", "port: spin, driver: ~"),
    # Controllers, poses, submechanisms, interfaces.
    ("controller-sensor", CONTROL, "sensors: [angles,", "sensors: [angels,"),
    ("controller-sensor-text", CONTROL, "sensors: [angles, speeds, weight]", "sensors: angles"),
    ("controller-motor", CONTROL, "motors: [slew,", "motors: [slow,"),
    ("controller-motor-joint", CONTROL, "motors: [slew,", "motors: [swing,"),
    ("controller-motor-twice", CONTROL, "motors: [slew, travel]", "motors: [slew, slew]"),
    ("controller-rate-negative", CONTROL, "rate: 20", "rate: -20"),
    ("controller-rate-fraction", CONTROL, "rate: 20", "rate: 0.02"),
    ("controller-rate-text", CONTROL, "rate: 20", "rate: fast"),
    ("controller-key", CONTROL, "sensors: [angles", "sensor: [angles"),
    ("pose-no-name", POSES, "{name: parked, joints", "{joints"),
    ("pose-duplicate", POSES, "{name: loading,", "{name: parked,"),
    ("pose-no-joints", POSES, "{name: parked, joints: {slew: 0.0, travel: 0.0}}", "{name: parked}"),
    ("pose-joints-list", POSES, "{slew: 0.0, travel: 0.0}", "[0.0, 0.0]"),
    ("pose-joint-unknown", POSES, "slew: 1.2", "slow: 1.2"),
    ("pose-joint-a-link", POSES, "slew: 1.2", "boom: 1.2"),
    ("pose-joint-fixed", POSES, "slew: 1.2", "foot: 1.2"),
    ("pose-joint-passive", POSES, "slew: 1.2", "swing: 0.2"),
    ("pose-above", POSES, "slew: 1.2", "slew: 3.0"),
    ("pose-below", POSES, "slew: 1.2", "slew: -2.2"),
    ("pose-degrees", POSES, "slew: 1.2", "slew: 68.75"),
    ("pose-millimetres", POSES, "travel: 0.8", "travel: 800"),
    ("pose-text", POSES, "slew: 1.2", "slew: left"),
    ("pose-unit", POSES, "slew: 1.2", "slew: 68 deg"),
    ("pose-nan", POSES, "slew: 1.2", "slew: .nan"),
    ("pose-list", POSES, "slew: 1.2", "slew: [1.2]"),
    ("pose-null", POSES, "slew: 1.2", "slew: "),
    ("pose-key-misspelt", POSES, "{name: loading, joints:", "{name: loading, joint:"),
    ("pose-duplicate-joint", POSES, "slew: 1.2", "slew: 1.2, slew: 1.3"),
    ("mechanism-joint-unknown", MECHANISM, "jointnames: [slew,", "jointnames: [slwe,"),
    ("mechanism-joint-a-link", MECHANISM, "jointnames: [slew,", "jointnames: [boom,"),
    ("mechanism-active-unknown", MECHANISM, "jointnames_active: [slew,", "jointnames_active: [slw,"),
    ("mechanism-active-not-listed", MECHANISM, "jointnames_active: [slew, travel]", "jointnames_active: [slew, swing]"),
    ("mechanism-joint-twice", MECHANISM, "jointnames: [slew, travel]", "jointnames: [slew, slew]"),
    ("mechanism-text", MECHANISM, "jointnames: [slew, travel]", "jointnames: slew"),
    ("mechanism-no-name", MECHANISM, "  - name: serial_chain\n    contextual_name", "  - contextual_name"),
    ("mechanism-no-context", MECHANISM, "    contextual_name: gantry\n", ""),
    ("mechanism-key", MECHANISM, "jointnames_independent:", "jointnames_independant:"),
    ("interface-parent", MECHANISM, "parent: hook", "parent: hok"),
    ("interface-no-parent", MECHANISM, "parent: hook, ", ""),
    ("interface-position-map", MECHANISM, "position: [0.0, 0.0, -0.03]", "position: {x: 0.0, y: 0.0, z: -0.03}"),
    ("interface-position-two", MECHANISM, "position: [0.0, 0.0, -0.03]", "position: [0.0, -0.03]"),
    ("interface-rotation-degrees", MECHANISM, "rotation: [0.0, 0.0, 0.0]", "rotation: [0.0, 0.0, 90.0]"),
]
