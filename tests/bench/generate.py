#!/usr/bin/env python3
"""Models and scenes of any size that lint clean, as load for benchmarks.

generate.py model LINKS FOLDER [tree|chain|star]   FOLDER/smurf/m.smurf with annotations, FOLDER/urdf/m.urdf
generate.py scene INSTANCES FOLDER                 FOLDER/world.smurfs, robots of one model of 40 links
generate.py many MODELS FOLDER                     FOLDER/NNNN/smurf/m.smurf, 20 links each
"""
import math
import pathlib
import sys

BOX = (0.08, 0.06, 0.1)  # m


def parent(i: int, shape: str) -> int:
    return {"chain": i - 1, "star": 0, "tree": (i - 1) // 3}[shape]


def link(i: int) -> str:
    size = " ".join(map(str, BOX))
    mass = 0.4 + 0.01 * (i % 7)  # kg
    ixx, iyy, izz = (f"{mass / 12 * (BOX[(k + 1) % 3] ** 2 + BOX[(k + 2) % 3] ** 2):.8f}" for k in range(3))
    return f"""\
  <link name="link_{i:06d}">
    <inertial>
      <origin xyz="0 0 0.05" rpy="0 0 0"/>
      <mass value="{mass:.2f}"/>
      <inertia ixx="{ixx}" ixy="0" ixz="0" iyy="{iyy}" iyz="0" izz="{izz}"/>
    </inertial>
    <visual name="visual_{i:06d}">
      <origin xyz="0 0 0.05" rpy="0 0 0"/>
      <geometry>
        <box size="{size}"/>
      </geometry>
      <material name="grey_{i % 10}"/>
    </visual>
    <collision name="collision_{i:06d}">
      <origin xyz="0 0 0.05" rpy="0 0 0"/>
      <geometry>
        <box size="{size}"/>
      </geometry>
    </collision>
  </link>
"""


def joint(i: int, shape: str) -> str:
    # Children of one link are placed around it, so that no two collisions coincide.
    angle = 2 * math.pi * i / 3
    x, y, z = (0.0, 0.0, 0.12) if shape == "chain" else (0.2 * math.cos(angle), 0.2 * math.sin(angle), 0.12)
    if shape == "star":
        x, y, z = 0.3 * (i % 25), 0.3 * (i // 25 % 25), 0.3 * (i // 625)
    return f"""\
  <joint name="joint_{i:06d}" type="revolute">
    <parent link="link_{parent(i, shape):06d}"/>
    <child link="link_{i:06d}"/>
    <origin xyz="{x:.4f} {y:.4f} {z:.2f}" rpy="0 0 {0.1 * (i % 7):.1f}"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="1.5" effort="20" velocity="2"/>
  </joint>
"""


def grey(i: int) -> str:
    return f"{0.2 + 0.05 * i:.2f}"


def model(links: int, folder: pathlib.Path, shape: str = "tree") -> None:
    (folder / "smurf").mkdir(parents=True, exist_ok=True)
    (folder / "urdf").mkdir(exist_ok=True)
    materials = "".join(
        f'  <material name="grey_{i}">\n    <color rgba="{grey(i)} {grey(i)} {grey(i)} 1"/>\n  </material>\n'
        for i in range(min(10, links)))
    (folder / "urdf/m.urdf").write_text(
        '<?xml version="1.0"?>\n<robot name="m">\n' + materials
        + "".join(link(i) for i in range(links))
        + "".join(joint(i, shape) for i in range(1, links)) + "</robot>\n")
    sections = {
        "motors": "".join(
            f"- name: joint_{i:06d}\n  joint: joint_{i:06d}\n  type: PID\n  p: {10 + i % 5}.0\n  i: 0.0\n  d: 0.1\n"
            "  minValue: -1.5\n  maxValue: 1.5\n  maxEffort: 20.0\n  maxSpeed: 2.0\n"
            for i in range(1, links)),
        "sensors": "".join(
            f"- name: imu_{i:06d}\n  type: NodeIMU\n  link: link_{i:06d}\n  id:\n  - link_{i:06d}\n  rate: 10\n"
            for i in range(links)),
        "collision": "".join(
            f"- {{name: collision_{i:06d}, link: link_{i:06d}, bitmask: 32769}}\n" for i in range(links)),
        "materials": "".join(
            f"- name: grey_{i}\n" + "".join(
                f"  {key}: {{r: {grey(i)}, g: {grey(i)}, b: {grey(i)}, a: 1.0}}\n"
                for key in ("ambientColor", "diffuseColor", "specularColor")) + "  shininess: 30.0\n"
            for i in range(min(10, links))),
    }
    for name, entries in sections.items():
        if entries:
            (folder / f"smurf/m_{name}.yml").write_text(f"# {name} of the model\n\n{name}:\n{entries}")
    files = ["../urdf/m.urdf", *(f"m_{name}.yml" for name, entries in sections.items() if entries)]
    (folder / "smurf/m.smurf").write_text(
        "SMURF version: 0.7\nmodelname: m\nfiles:\n" + "".join(f"- {file}\n" for file in files))


def scene(instances: int, folder: pathlib.Path) -> None:
    model(40, folder / "robot")
    columns = math.isqrt(instances) + 1
    (folder / "world.smurfs").write_text("entities:\n" + "".join(
        f"- name: robot_{i:06d}\n  type: smurf\n  file: robot/smurf/m.smurf\n"
        f"  position: [{30 * (i % columns)}.0, {30 * (i // columns)}.0, 0.0]\n  rotation: [0.0, 0.0, {i % 360}.0]\n"
        for i in range(instances)))


def many(models: int, folder: pathlib.Path) -> None:
    for i in range(models):
        model(20, folder / f"{i:04d}")


def main() -> None:
    kind, size, folder = sys.argv[1], int(sys.argv[2]), pathlib.Path(sys.argv[3])
    {"model": model, "scene": scene, "many": many}[kind](size, folder, *sys.argv[4:])


if __name__ == "__main__":
    main()
