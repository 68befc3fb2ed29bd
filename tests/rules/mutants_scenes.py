# SPDX-License-Identifier: BSD-3-Clause
"""One-defect changes of scenes: (name, file, text as it stands, text with the defect, where if not there).

The text as it stands occurs once in the file, or its first occurrence is meant. `where` is a text of the
line that the finding is expected at, for defects that are seen elsewhere than where they are made.
"""
import mutants_smurf

HALL = "hall/hall.smurfs"
CELL = "hall/cell.smurfs"
GROUP = "hall/group.smurfa"
RAINBOW = "scenes/example/environment/rainbow.yml"
EXAMPLE = "scenes/example/example.smurfs"
ENTRIES = {"hall/": HALL, "scenes/example/": EXAMPLE}

# Usually one line per entity, so that a finding on an entity is at its line.
FILES = {
    HALL: """# a hall with two cranes, a cell and a group
physics:
  gravity: {x: 0.0, y: 0.0, z: -9.81}
  ode: {stepsize: 10, cfm: 1.0e-10, erp: 0.2}
environment:
  background: {r: 0.6, g: 0.7, b: 0.8, a: 1.0}
  fog: {density: 0.1, start: 50.0, end: 200.0, color: {r: 0.6, g: 0.7, b: 0.8, a: 1.0}}
lights:
  - {name: roof, type: 1, directional: false, position: {x: 0.0, y: 0.0, z: 8.0}, lookat: {x: 0.0, y: 0.0, z: 0.0}, angle: 90.0, exponent: 0.0, ambient: {r: 0.1, g: 0.1, b: 0.1, a: 1.0}, diffuse: {r: 0.9, g: 0.9, b: 0.9, a: 1.0}, specular: {r: 0.5, g: 0.5, b: 0.5, a: 1.0}, constantAttenuation: 1.0, linearAttenuation: 0.0, quadraticAttenuation: 0.01}
entities:
  - {name: North, type: smurf, file: ../crane/crane.smurf, position: [0.0, 4.0, 0.0], rotation: [0.0, 0.0, 90.0], anchor: world, pose: parked}
  - {name: South, type: smurf, file: ../crane/crane.smurf, position: [0.0, -4.0, 0.0], rotation: [0.7071068, 0.0, 0.0, 0.7071068], anchor: world, pose: loading}
  - {name: Toolbox, type: urdf, file: box.urdf, parent: "North::hook", anchor: parent, position: [0.0, 0.0, -0.1], rotation: [45]}
  - {name: Cell, type: smurfs, file: cell.smurfs, position: [3.0, 0.0, 0.0], rotation: [0.0, 0.0, 180.0], anchor: world}
  - {name: Group, type: smurfa, file: group.smurfa, parent: "South::hook", anchor: parent, position: [0.0, 0.0, -0.5]}
  - {name: Floor, type: primitive, geometry: {type: plane}, movable: false, extend: {x: 20.0, y: 20.0, z: 0.1}, position: {x: 0.0, y: 0.0, z: 0.0}}
  - {name: Block, type: primitive, geometry: {type: box}, mass: 2.0, extend: {x: 0.4, y: 0.3, z: 0.2}, position: {x: 1.0, y: 1.0, z: 0.1}, rotation: {w: 1.0, x: 0.0, y: 0.0, z: 0.0}, material: {name: wood, diffuseColor: {r: 0.6, g: 0.4, b: 0.2, a: 1.0}}}
  - {name: Ball, type: primitive, geometry: {type: sphere}, mass: 0.5, extend: {x: 0.1, y: 0.1, z: 0.1}, position: {x: 2.0, y: 1.0, z: 0.1}}
  - {name: Hill, type: heightmap, file: hill.png, position: [9.0, 0.0, 0.0], width: 6.0, length: 6.0, height: 0.8}
""",
    CELL: """entities:
  - {name: Shelf, file: box.urdf, position: [0.0, 1.0, 0.0], rotation: [0.0, 0.0, 90.0]}
  - {name: Crate, file: box.urdf, parent: "Shelf::top", anchor: parent, position: [0.0, 0.0, 0.2]}
""",
    GROUP: """smurfa:
  - {name: Chief, file: box.urdf, root: true, position: [0.0, 0.0, 0.5]}
  - {name: Helper, file: box.urdf, parent: "Chief::top", anchor: parent, position: [0.0, 0.5, 0.0]}
""",
    "hall/box.urdf": """<?xml version="1.0" encoding="utf-8"?>
<robot name="box">
  <link name="body">
    <inertial><mass value="2"/><inertia ixx="0.007" ixy="0" ixz="0" iyy="0.007" iyz="0" izz="0.007"/></inertial>
    <visual name="body_visual"><geometry><box size="0.2 0.2 0.2"/></geometry></visual>
    <collision name="body_collision"><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
  </link>
  <link name="top"/>
  <joint name="lid" type="fixed"><parent link="body"/><child link="top"/><origin xyz="0 0 0.1"/></joint>
</robot>
""",
    "hall/hill.png": b"\x89PNG\r\n\x1a\n",
    **mutants_smurf.FILES,
}

NORTH = "position: [0.0, 4.0, 0.0], rotation: [0.0, 0.0, 90.0]"

MUTANTS = [
    # The file as a whole.
    ("hall-misspelt-entities", HALL, "entities:", "entites:"),
    ("hall-case-of-entities", HALL, "entities:", "Entities:"),
    ("hall-entity-singular", HALL, "entities:", "entity:"),
    ("hall-robots", CELL, "entities:\n", "robots:\n"),
    ("hall-entities-map", CELL, "entities:\n  - {name: Shelf,", "entities:\n  Shelf: {"),
    ("hall-entities-text", CELL, "entities:\n", "entities: none\nothers:\n"),
    ("hall-entity-scalar", HALL, "entities:\n", "entities:\n  - North\n"),
    ("hall-entity-null", HALL, "entities:\n", "entities:\n  -\n"),
    ("hall-both-lists", HALL, "entities:\n", "smurfs:\n  - {name: Old, file: box.urdf}\nentities:\n"),
    ("hall-root-list", CELL, "entities:\n  - {name: Shelf", "- {name: Shelf"),
    ("hall-tab", HALL, "  gravity:", "\tgravity:"),
    ("hall-duplicate-key", HALL, "environment:", "physics: {}\nenvironment:"),
    ("hall-second-document", HALL, "entities:", "---\nentities:"),
    ("hall-unclosed-bracket", HALL, "position: [0.0, 4.0, 0.0]", "position: [0.0, 4.0, 0.0"),
    ("hall-anchor-alias", HALL, "anchor: world, pose: parked", "anchor: *world, pose: parked"),
    # Physics and environment.
    ("hall-physics-misspelt", HALL, "physics:", "physic:"),
    ("hall-physics-list", HALL, "physics:\n  gravity: {x: 0.0, y: 0.0, z: -9.81}\n  ode: {stepsize: 10, cfm: 1.0e-10, erp: 0.2}", "physics: [0.0, 0.0, -9.81]"),
    ("hall-gravity-list", HALL, "gravity: {x: 0.0, y: 0.0, z: -9.81}", "gravity: [0.0, 0.0, -9.81]"),
    ("hall-gravity-number", HALL, "gravity: {x: 0.0, y: 0.0, z: -9.81}", "gravity: -9.81"),
    ("hall-gravity-up", HALL, "z: -9.81", "z: 9.81"),
    ("hall-gravity-large", HALL, "z: -9.81", "z: -981"),
    ("hall-gravity-text", HALL, "z: -9.81", "z: down"),
    ("hall-gravity-unit", HALL, "z: -9.81", "z: -9.81 m/s^2"),
    ("hall-gravity-component", HALL, "z: -9.81", "Z: -9.81"),
    ("hall-gravity-component-missing", HALL, "gravity: {x: 0.0, y: 0.0, z: -9.81}", "gravity: {x: 0.0, y: 0.0}"),
    ("hall-gravity-along-y", HALL, "y: 0.0, z: -9.81", "y: -9.81, z: 0.0"),
    ("hall-gravity-misspelt", HALL, "gravity:", "gravitiy:"),
    ("hall-step-zero", HALL, "stepsize: 10", "stepsize: 0"),
    ("hall-step-negative", HALL, "stepsize: 10", "stepsize: -10"),
    ("hall-step-seconds", HALL, "stepsize: 10", "stepsize: 0.01"),
    ("hall-step-long", HALL, "stepsize: 10", "stepsize: 10000"),
    ("hall-step-text", HALL, "stepsize: 10", "stepsize: 10ms"),
    ("hall-step-misspelt", HALL, "stepsize: 10", "stepsze: 10"),
    ("hall-step-style", HALL, "stepsize: 10", "step_size: 10"),
    ("hall-cfm-notation", HALL, "cfm: 1.0e-10", "cfm: 1e-10"),
    ("hall-cfm-negative", HALL, "cfm: 1.0e-10", "cfm: -1.0e-10"),
    ("hall-erp-large", HALL, "erp: 0.2", "erp: 2.0"),
    ("hall-ode-misspelt", HALL, "  ode:", "  odee:"),
    ("hall-ode-case", HALL, "  ode:", "  ODE:"),
    ("hall-environment-misspelt", HALL, "environment:", "enviroment:"),
    ("hall-background-list", HALL, "background: {r: 0.6, g: 0.7, b: 0.8, a: 1.0}", "background: [0.6, 0.7, 0.8, 1.0]"),
    ("hall-background-255", HALL, "background: {r: 0.6, g: 0.7, b: 0.8, a: 1.0}", "background: {r: 153, g: 179, b: 204, a: 255}"),
    ("hall-background-text", HALL, "background: {r: 0.6, g: 0.7, b: 0.8, a: 1.0}", "background: blue"),
    ("hall-background-misspelt", HALL, "background:", "backgroud:"),
    ("hall-fog-swapped", HALL, "start: 50.0, end: 200.0", "start: 200.0, end: 50.0"),
    ("hall-fog-negative", HALL, "density: 0.1", "density: -0.1"),
    ("hall-fog-text", HALL, "density: 0.1", "density: thick"),
    ("hall-fog-bool", HALL, "fog: {density: 0.1, start: 50.0, end: 200.0, color: {r: 0.6, g: 0.7, b: 0.8, a: 1.0}}", "fog: true"),
    ("hall-fog-key", HALL, "density: 0.1", "densty: 0.1"),
    ("hall-fog-colour", HALL, "end: 200.0, color:", "end: 200.0, colour:"),
    ("hall-skybox", HALL, "  background:", "  skybox: {path: sky}\n  background:"),
    # Lights.
    ("hall-light-type", HALL, "type: 1", "type: 7"),
    ("hall-light-type-text", HALL, "type: 1", "type: omni"),
    ("hall-light-position", HALL, "position: {x: 0.0, y: 0.0, z: 8.0}", "position: [0.0, 0.0, 8.0]"),
    ("hall-light-colour", HALL, "diffuse: {r: 0.9, g: 0.9, b: 0.9, a: 1.0}", "diffuse: {r: 230, g: 230, b: 230, a: 255}"),
    ("hall-light-colour-list", HALL, "diffuse: {r: 0.9, g: 0.9, b: 0.9, a: 1.0}", "diffuse: [0.9, 0.9, 0.9, 1.0]"),
    ("hall-light-missing", HALL, ", constantAttenuation: 1.0", ""),
    ("hall-light-misspelt", HALL, "lookat:", "lookAt:"),
    ("hall-light-attenuation", HALL, "linearAttenuation: 0.0", "linearAttenuation: -0.5"),
    ("hall-light-attenuation-text", HALL, "linearAttenuation: 0.0", "linearAttenuation: none"),
    ("hall-lights-map", HALL, "lights:\n  - {name", "lights:\n  roof: {name"),
    ("hall-lights-misspelt", HALL, "lights:", "ligths:"),
    ("hall-light-singular", HALL, "lights:", "light:"),
    ("hall-light-directional", HALL, "directional: false", "directional: off"),
    # Kinds of entities.
    ("hall-anchor-for-parent", CELL, 'parent: "Shelf::top", anchor: parent', 'anchor: "Shelf::top"'),
    ("hall-no-file", HALL, "type: smurf, file: ../crane/crane.smurf, ", ""),
    ("hall-file-missing", HALL, "file: box.urdf", "file: bx.urdf"),
    ("hall-file-case", HALL, "file: box.urdf", "file: Box.urdf"),
    ("hall-file-backslash", HALL, "file: ../crane/crane.smurf", "file: ..\\crane\\crane.smurf"),
    ("hall-file-absolute", HALL, "file: ../crane/crane.smurf", "file: /home/ann/crane.smurf"),
    ("hall-file-empty", HALL, "type: urdf, file: box.urdf", "type: urdf, file: ''"),
    ("hall-file-null", HALL, "type: urdf, file: box.urdf", "type: urdf, file: "),
    ("hall-file-list", HALL, "type: urdf, file: box.urdf", "type: urdf, file: [box.urdf]"),
    ("hall-file-misspelt", HALL, "type: urdf, file: box.urdf", "type: urdf, flie: box.urdf"),
    ("hall-file-uri", HALL, "type: urdf, file: box.urdf", "type: urdf, URI: box.urdf"),
    ("hall-file-package", HALL, "file: box.urdf", "file: package://hall/box.urdf"),
    ("hall-file-archive", HALL, "type: smurf, file: ../crane/crane.smurf", "file: ../crane/crane.zsmurf"),
    ("hall-file-no-ending", HALL, "type: smurf, file: ../crane/crane.smurf", "file: ../crane/crane"),
    ("hall-file-sdf", HALL, "type: urdf, file: box.urdf", "file: box.sdf"),
    ("hall-type-misspelt", HALL, "type: smurf, file", "type: smurff, file"),
    ("hall-type-case", HALL, "type: smurf, file", "type: SMURF, file"),
    ("hall-type-other", HALL, "type: smurf, file", "type: urdf, file"),
    ("hall-type-smurfs", HALL, "type: smurf, file", "type: smurfs, file"),
    ("hall-type-unknown", HALL, "type: smurf, file", "type: robot, file"),
    ("hall-type-number", HALL, "type: smurf, file", "type: 1, file"),
    ("hall-type-list", HALL, "type: smurf, file", "type: [smurf], file"),
    ("hall-scene-as-smurf", HALL, "type: smurfs, file: cell.smurfs", "type: smurf, file: cell.smurfs"),
    ("hall-name-missing", HALL, "{name: Block, type", "{type"),
    ("hall-name-empty", HALL, "{name: Block,", "{name: '',"),
    ("hall-name-null", HALL, "{name: Block,", "{name: ,"),
    ("hall-name-list", HALL, "{name: Block,", "{name: [Block],"),
    ("hall-name-duplicate", HALL, "{name: South,", "{name: North,"),
    ("hall-name-nested-duplicate", CELL, "{name: Shelf,", "{name: South,"),
    ("hall-name-separator", HALL, "{name: Block,", '{name: "A::Block",'),
    ("hall-key-misspelt", HALL, NORTH, "postion: [0.0, 4.0, 0.0], rotation: [0.0, 0.0, 90.0]"),
    ("hall-key-case", HALL, NORTH, "Position: [0.0, 4.0, 0.0], rotation: [0.0, 0.0, 90.0]"),
    ("hall-rotation-misspelt", HALL, NORTH, "position: [0.0, 4.0, 0.0], roation: [0.0, 0.0, 90.0]"),
    ("hall-orientation", HALL, NORTH, "position: [0.0, 4.0, 0.0], orientation: [0.0, 0.0, 90.0]"),
    ("hall-translation", HALL, NORTH, "translation: [0.0, 4.0, 0.0], rotation: [0.0, 0.0, 90.0]"),
    ("hall-anchor-misspelt", HALL, "anchor: world, pose: parked", "ancor: world, pose: parked"),
    ("hall-pose-misspelt", HALL, "pose: parked", "posse: parked"),
    ("hall-poses-key", HALL, "pose: parked", "poses: parked"),
    ("hall-duplicate-entity-key", HALL, NORTH, "position: [1.0, 4.0, 0.0], " + NORTH),
    # Where it is.
    ("hall-position-two", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "[0.0, 4.0]")),
    ("hall-position-four", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "[0.0, 4.0, 0.0, 1.0]")),
    ("hall-position-text", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "0.0 4.0 0.0")),
    ("hall-position-scalar", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "4.0")),
    ("hall-position-empty", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "[]")),
    ("hall-position-unit", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "[0.0, 4.0m, 0.0]")),
    ("hall-position-comma", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "[0,0, 4,0, 0,0]")),
    ("hall-position-nan", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "[0.0, .nan, 0.0]")),
    ("hall-position-null", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "[0.0, ~, 0.0]")),
    ("hall-position-nested", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "[[0.0, 4.0, 0.0]]")),
    ("hall-position-far", HALL, NORTH, NORTH.replace("4.0", "4.0e+9")),
    ("hall-position-millimetres", HALL, NORTH, NORTH.replace("4.0", "400000.0")),
    ("hall-position-component", HALL, NORTH, NORTH.replace("[0.0, 4.0, 0.0]", "{x: 0.0, Y: 4.0, z: 0.0}")),
    ("hall-position-expression", HALL, NORTH, NORTH.replace("4.0", "2*2")),
    ("hall-rotation-two", HALL, NORTH, NORTH.replace("[0.0, 0.0, 90.0]", "[0.0, 90.0]")),
    ("hall-rotation-five", HALL, NORTH, NORTH.replace("[0.0, 0.0, 90.0]", "[0.0, 0.0, 90.0, 0.0, 0.0]")),
    ("hall-rotation-empty", HALL, NORTH, NORTH.replace("[0.0, 0.0, 90.0]", "[]")),
    ("hall-rotation-text", HALL, NORTH, NORTH.replace("[0.0, 0.0, 90.0]", "[0.0, 0.0, 90deg]")),
    ("hall-rotation-map", HALL, NORTH, NORTH.replace("[0.0, 0.0, 90.0]", "{x: 0.0, y: 0.0, z: 90.0}")),
    ("hall-rotation-rpy-map", HALL, NORTH, NORTH.replace("[0.0, 0.0, 90.0]", "{roll: 0.0, pitch: 0.0, yaw: 90.0}")),
    ("hall-rotation-radians", HALL, NORTH, NORTH.replace("90.0", "1.5708")),
    ("hall-rotation-radians-pi", HALL, NORTH, NORTH.replace("90.0", "3.14159")),
    ("hall-rotation-radians-short", HALL, NORTH, NORTH.replace("90.0", "1.57")),
    ("hall-rotation-radians-scalar", HALL, "rotation: [45]", "rotation: [0.7854]"),
    ("hall-rotation-large", HALL, NORTH, NORTH.replace("90.0", "9000.0")),
    ("hall-rotation-inf", HALL, NORTH, NORTH.replace("90.0", ".inf")),
    ("hall-quaternion-length", HALL, "rotation: [0.7071068, 0.0, 0.0, 0.7071068]", "rotation: [1.0, 0.0, 0.0, 1.0]"),
    ("hall-quaternion-slightly", HALL, "rotation: [0.7071068, 0.0, 0.0, 0.7071068]", "rotation: [0.7, 0.0, 0.0, 0.7]"),
    ("hall-quaternion-zero", HALL, "rotation: [0.7071068, 0.0, 0.0, 0.7071068]", "rotation: [0.0, 0.0, 0.0, 0.0]"),
    ("hall-quaternion-xyzw", HALL, "rotation: [0.7071068, 0.0, 0.0, 0.7071068]", "rotation: [0.0, 0.0, 0.0, 1.0]"),
    ("hall-quaternion-degrees", HALL, "rotation: [0.7071068, 0.0, 0.0, 0.7071068]", "rotation: [0.0, 0.0, 90.0, 0.0]"),
    ("hall-quaternion-map-part", HALL, "rotation: [0.7071068, 0.0, 0.0, 0.7071068]", "rotation: {w: 0.7071068, x: 0.0, z: 0.7071068}"),
    ("hall-parent-entity", HALL, '"North::hook"', '"Nroth::hook"'),
    ("hall-parent-entity-case", HALL, '"North::hook"', '"north::hook"'),
    ("hall-parent-link", HALL, '"North::hook"', '"North::hok"'),
    ("hall-parent-joint", HALL, '"North::hook"', '"North::swing"'),
    ("hall-parent-no-link", HALL, '"North::hook"', "North"),
    ("hall-parent-empty-link", HALL, '"North::hook"', '"North::"'),
    ("hall-parent-empty-entity", HALL, '"North::hook"', '"::hook"'),
    ("hall-parent-colon", HALL, '"North::hook"', '"North:hook"'),
    ("hall-parent-dot", HALL, '"North::hook"', '"North.hook"'),
    ("hall-parent-slash", HALL, '"North::hook"', '"North/hook"'),
    ("hall-parent-itself", HALL, '"North::hook"', '"Toolbox::top"'),
    ("hall-parent-of-scene", HALL, '"North::hook"', '"Cell::top"'),
    ("hall-parent-of-primitive", HALL, '"North::hook"', '"Block::top"'),
    ("hall-parent-list", HALL, 'parent: "North::hook"', 'parent: [North, hook]'),
    ("hall-parent-case", HALL, 'parent: "North::hook"', "parent: WORLD"),
    ("hall-parent-cycle", HALL, "position: [0.0, 4.0, 0.0], rotation: [0.0, 0.0, 90.0], anchor: world", 'parent: "Toolbox::top", anchor: parent'),
    ("hall-parent-not-anchored", HALL, "anchor: parent, position: [0.0, 0.0, -0.1]", "position: [0.0, 0.0, -0.1]"),
    ("hall-parent-later", HALL, '"North::hook", anchor: parent', '"Later::top"'),
    ("hall-parent-missing", HALL, 'parent: "North::hook", ', ""),
    ("hall-parent-misspelt", HALL, "parent: ", "parnt: "),
    ("hall-anchor-word", HALL, "anchor: world", "anchor: wolrd"),
    ("hall-anchor-case", HALL, "anchor: world", "anchor: World"),
    ("hall-anchor-none-case", HALL, "anchor: world", "anchor: None"),
    ("hall-anchor-true", HALL, "anchor: world", "anchor: true"),
    ("hall-anchor-no", HALL, "anchor: world", "anchor: no"),
    ("hall-anchor-fixed", HALL, "anchor: world", "anchor: fixed"),
    ("hall-anchor-number", HALL, "anchor: world", "anchor: 1"),
    ("hall-anchor-list", HALL, "anchor: world", "anchor: [world]"),
    ("hall-anchor-parent-alone", HALL, "anchor: world", "anchor: parent"),
    ("hall-anchor-link", HALL, "anchor: world", 'anchor: "South::bse"'),
    ("hall-anchor-entity", HALL, "anchor: world", 'anchor: "Suoth::base"'),
    ("hall-anchor-itself", HALL, "anchor: world", 'anchor: "North::boom"'),
    ("hall-anchor-without-link", HALL, "anchor: world", "anchor: South"),
    ("hall-pose-unknown", HALL, "pose: parked", "pose: praked"),
    ("hall-pose-case", HALL, "pose: parked", "pose: Parked"),
    ("hall-pose-list", HALL, "pose: parked", "pose: [parked]"),
    ("hall-pose-map", HALL, "pose: parked", "pose: {slew: 0.1}"),
    ("hall-pose-of-urdf", HALL, "type: urdf, file: box.urdf,", "type: urdf, file: box.urdf, pose: open,"),
    # Nested scenes and assemblies.
    ("hall-cell-file", HALL, "file: cell.smurfs", "file: cel.smurfs"),
    ("hall-cell-itself", HALL, "file: cell.smurfs", "file: hall.smurfs"),
    ("hall-cell-type", HALL, "type: smurfs, file: cell.smurfs", "type: smurfs, file: box.urdf"),
    ("cell-includes-back", CELL, "{name: Shelf, file: box.urdf,", "{name: Back, file: hall.smurfs}\n  - {name: Shelf, file: box.urdf,"),
    ("cell-anchor-lost", CELL, "rotation: [0.0, 0.0, 90.0]", "anchor: none"),
    ("cell-position-map", CELL, "position: [0.0, 1.0, 0.0]", "position: {x: 0.0, y: 1.0, z: 0.0}"),
    ("cell-rotation-map", CELL, "rotation: [0.0, 0.0, 90.0]", "rotation: {w: 1.0, x: 0.0, y: 0.0, z: 0.0}"),
    ("cell-rotation-two", CELL, "rotation: [0.0, 0.0, 90.0]", "rotation: [0.0, 90.0]"),
    ("cell-parent-none", CELL, "rotation: [0.0, 0.0, 90.0]", "parent: none"),
    ("cell-parent-unknown", CELL, '"Shelf::top"', '"Shelv::top"'),
    ("cell-parent-link", CELL, '"Shelf::top"', '"Shelf::tp"'),
    ("cell-primitive", CELL, "entities:\n", "entities:\n  - {name: Cube, type: primitive, geometry: {type: box}}\n"),
    ("cell-root", CELL, "rotation: [0.0, 0.0, 90.0]", "root: true"),
    ("cell-file", CELL, "{name: Shelf, file: box.urdf", "{name: Shelf, file: shelf.urdf"),
    ("cell-physics", CELL, "entities:", "physics: {gravity: {x: 0.0, y: 0.0, z: -1.62}}\nentities:"),
    ("cell-environment", CELL, "entities:", "environment: {background: {r: 0.0, g: 0.0, b: 0.0, a: 1.0}}\nentities:"),
    ("group-no-root", GROUP, "root: true, ", ""),
    ("group-root-text", GROUP, "root: true", "root: yes"),
    ("group-root-misspelt", GROUP, "root: true", "rot: true"),
    ("group-left-behind", GROUP, 'parent: "Chief::top", anchor: parent, ', ""),
    ("group-physics", GROUP, "smurfa:", "physics: {gravity: {x: 0.0, y: 0.0, z: -9.81}}\nsmurfa:"),
    ("group-lights", GROUP, "smurfa:", "lights: []\nsmurfa:"),
    ("group-key", GROUP, "smurfa:", "smurfsa:"),
    # Primitives and height maps.
    ("hall-primitive-list", HALL, "position: {x: 0.0, y: 0.0, z: 0.0}", "position: [0.0, 0.0, 0.0]"),
    ("hall-primitive-rotation", HALL, "rotation: {w: 1.0, x: 0.0, y: 0.0, z: 0.0}", "rotation: [0.0, 0.0, 45.0]"),
    ("hall-primitive-shape", HALL, "geometry: {type: box}", "geometry: {type: bx}"),
    ("hall-primitive-shape-case", HALL, "geometry: {type: box}", "geometry: {type: Box}"),
    ("hall-primitive-shape-missing", HALL, " geometry: {type: box},", ""),
    ("hall-primitive-geometry-text", HALL, "geometry: {type: box}", "geometry: box"),
    ("hall-primitive-geometry-key", HALL, "geometry: {type: box}", "geometry: {typ: box}"),
    ("hall-primitive-size-list", HALL, "extend: {x: 0.4, y: 0.3, z: 0.2}", "extend: [0.4, 0.3, 0.2]"),
    ("hall-primitive-size-zero", HALL, "extend: {x: 0.4, y: 0.3, z: 0.2}", "extend: {x: 0.4, y: 0.0, z: 0.2}"),
    ("hall-primitive-size-negative", HALL, "extend: {x: 0.4, y: 0.3, z: 0.2}", "extend: {x: -0.4, y: 0.3, z: 0.2}"),
    ("hall-primitive-size-part", HALL, "extend: {x: 0.4, y: 0.3, z: 0.2}", "extend: {x: 0.4, y: 0.3}"),
    ("hall-primitive-size-text", HALL, "extend: {x: 0.4, y: 0.3, z: 0.2}", "extend: {x: 0.4, y: 0.3, z: flat}"),
    ("hall-primitive-size-misspelt", HALL, "extend: {x: 0.4, y: 0.3, z: 0.2}", "extent: {x: 0.4, y: 0.3, z: 0.2}"),
    ("hall-primitive-mass-negative", HALL, "mass: 2.0", "mass: -2.0"),
    ("hall-primitive-mass-text", HALL, "mass: 2.0", "mass: 2kg"),
    ("hall-primitive-mass-misspelt", HALL, "mass: 2.0", "mas: 2.0"),
    ("hall-primitive-movable", HALL, "movable: false", "movable: no"),
    ("hall-primitive-anchor", HALL, "mass: 2.0", "anchor: world"),
    ("hall-primitive-material", HALL, "diffuseColor: {r: 0.6, g: 0.4, b: 0.2, a: 1.0}", "diffuseColor: [0.6, 0.4, 0.2, 1.0]"),
    ("hall-primitive-material-255", HALL, "diffuseColor: {r: 0.6,", "diffuseColor: {r: 153,"),
    ("hall-primitive-material-text", HALL, "material: {name: wood, diffuseColor: {r: 0.6, g: 0.4, b: 0.2, a: 1.0}}", "material: wood"),
    ("hall-primitive-quaternion", HALL, "rotation: {w: 1.0,", "rotation: {w: 2.0,"),
    ("hall-primitive-quaternion-zero", HALL, "rotation: {w: 1.0,", "rotation: {w: 0.0,"),
    ("hall-primitive-euler", HALL, "rotation: {w: 1.0, x: 0.0, y: 0.0, z: 0.0}", "rotation: {x: 0.0, y: 0.0, z: 45.0}"),
    ("hall-sphere-size", HALL, "extend: {x: 0.1, y: 0.1, z: 0.1}", "extend: {x: 0.0, y: 0.0, z: 0.0}"),
    ("hall-sphere-radius", HALL, "extend: {x: 0.1, y: 0.1, z: 0.1}", "radius: 0.1"),
    ("hall-map-missing", HALL, "file: hill.png", "file: hil.png"),
    ("hall-map-not-an-image", HALL, "file: hill.png", "file: box.urdf"),
    ("hall-map-no-file", HALL, " file: hill.png,", ""),
    ("hall-map-width", HALL, "width: 6.0", "width: 0"),
    ("hall-map-width-negative", HALL, "width: 6.0", "width: -6.0"),
    ("hall-map-width-text", HALL, "width: 6.0", "width: six"),
    ("hall-map-width-missing", HALL, " width: 6.0,", ""),
    ("hall-map-misspelt", HALL, "width: 6.0", "widht: 6.0"),
    ("hall-map-height", HALL, "height: 0.8", "height: tall"),
    ("hall-map-rotation", HALL, "width: 6.0", "width: 6.0, rotation: [1.0, 0.0]"),
    # Custom entity types.
    ("rainbow-radius", RAINBOW, "radius: 400.0", "radius: -400.0"),
    ("rainbow-radius-text", RAINBOW, "radius: 400.0", "radius: wide"),
    ("rainbow-radius-missing", RAINBOW, "  radius: 400.0        # metres, outer edge\n", ""),
    ("rainbow-opacity", RAINBOW, "opacity: 0.35", "opacity: 35"),
    ("rainbow-misspelt", RAINBOW, "opacity: 0.35", "opacty: 0.35"),
    ("rainbow-colour", RAINBOW, "color: {r: 0.9,", "color: {r: 230,"),
    ("rainbow-colour-list", RAINBOW, "color: {r: 0.9, g: 0.1, b: 0.1, a: 1.0}", "color: [0.9, 0.1, 0.1, 1.0]"),
    ("rainbow-band-name", RAINBOW, "name: red", "nme: red"),
    ("rainbow-section", RAINBOW, "rainbow:", "rainbw:"),
    ("rainbow-position", EXAMPLE, "  position: [1500.0, 300.0, 270.0]\n", ""),
    ("rainbow-position-two", EXAMPLE, "position: [1500.0, 300.0, 270.0]", "position: [1500.0, 300.0]"),
    ("rainbow-type", EXAMPLE, "type: rainbow ", "type: rainbo "),
    ("rainbow-file", EXAMPLE, "file: environment/rainbow.yml", "file: environment/rainbo.yml"),
]
