# SPDX-License-Identifier: BSD-3-Clause
"""The page of `smurfs-flatten --format html`. Tests are also skipped when the tool was built without the viewer."""
import json
import math
import random
import subprocess

from browser import BrowserTest, cli, main, reader  # noqa: F401

TOLERANCE = 1e-6
# Poses of the three.js scene: X_WE of every entity, X_WL of every link, and where each shape is drawn.
READ = """({
  entities: smurfViewer.motion.entities.map((matrix) => matrix?.elements),
  links: smurfViewer.motion.links.map((links) => links.map((matrix) => matrix?.elements)),
  drawn: smurfViewer.shapes.solids.filter(({ shape }) => !shape.around).map(({ entity, link, shape, local, batch, index }) => ({
    entity, link, pose: shape.pose, at: batch.mesh.getMatrixAt(index, local.clone()).elements.slice(12, 15) })),
})"""


def set_positions(entity, positions):
    return (f"smurfViewer.motion.set({entity}, new Map({json.dumps(list(positions.items()))})), "
            "smurfViewer.move(), smurfViewer.stage.renderer.render(smurfViewer.stage.scene, smurfViewer.stage.camera)")


def matrix_of(pose):
    """A matrix in column-major order, as in three.js."""
    x, y, z = pose["position"]
    w, i, j, k = (pose["orientation"][key] for key in "wxyz")
    return [1 - 2 * (j * j + k * k), 2 * (i * j + k * w), 2 * (i * k - j * w), 0,
            2 * (i * j - k * w), 1 - 2 * (i * i + k * k), 2 * (j * k + i * w), 0,
            2 * (i * k + j * w), 2 * (j * k - i * w), 1 - 2 * (i * i + j * j), 0, x, y, z, 1]


def joint_configurations(model, count, seed):
    """Random positions, within their limits, for the joints of a model in a page."""
    rng = random.Random(seed)
    configurations = []
    for _ in range(count):
        positions = {}
        for joint in model["joints"]:
            if "axis" not in joint or "leader" in joint or "name" not in joint:
                continue
            low, high = sorted((joint.get("lower", -3), joint.get("upper", 3)))
            positions[joint["name"]] = rng.uniform(max(low, -100), min(high, 100))
        configurations.append(positions)
    return configurations


class ViewerTest(BrowserTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        done = subprocess.run([cli.TOOL, "--format", "html", cli.FIXTURES / "models/arm/urdf/arm.urdf"], check=False,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8")
        if done.returncode == 2 and "this build has no viewer: run scripts/viewer" in done.stderr:
            cls.skipTest(cls, "this build has no viewer")

    def page(self, scene, name="page.html", code=0):
        done = self.run_tool(scene, "--format", "html", "-o", name, "--quiet", "--allow-outside", "--force")
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        return self.folder / name

    def data(self, page):
        return self.data_in(page, "scene")

    def flat(self, scene):
        done = self.run_tool(scene, "--links", "--quiet", "--allow-outside", "--force")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def posed(self, urdf, configurations):
        """The flat JSON of a scene with the robot in each of the configurations."""
        self.write("posed/robot.urdf", urdf)
        self.write("posed/robot.smurf", "modelname: robot\nfiles: [robot.urdf, poses.yml]\n")
        self.write("posed/poses.yml", json.dumps({"poses": [{"name": f"p{i}", "joints": positions or {"none": 0}}
                                                            for i, positions in enumerate(configurations)]}))
        self.write("posed/scene.smurfs", json.dumps({"entities": [
            {"name": f"R{i}", "file": "robot.smurf", "pose": f"p{i}"} for i in range(len(configurations))]}))
        return self.flat(self.folder / "posed/scene.smurfs")["instances"]

    def assert_close(self, found, expected, what):
        size = max(1, *(abs(value) for value in expected))
        gap = max(abs(a - b) for a, b in zip(found, expected))
        self.assertLessEqual(gap, TOLERANCE * size, f"{what}: {found} is not {expected}")

    def assert_poses(self, read, data, instances, whose):
        """Compares what READ returned with the flat JSON; `instances` are in the order of the page's entities."""
        worlds = {}
        for index, instance in enumerate(instances):
            if instance is None:
                continue
            worlds[index, None] = matrix_of(instance)
            self.assert_close(read["entities"][index], worlds[index, None], f"{whose}: {instance['path']}")
            model = data["entities"][index].get("model")
            if model is None:
                continue
            for at, link in enumerate(data["models"][model]["links"]):
                pose = instance["links"].get(link.get("name"))
                self.assertEqual("unplaced" in link, read["links"][index][at] is None)
                if pose is None or "unplaced" in link:
                    continue
                worlds[index, at] = matrix_of(pose)
                self.assert_close(read["links"][index][at], worlds[index, at], f"{whose}: {link['name']}")
        for shape in read["drawn"]:
            world = worlds.get((shape["entity"], shape.get("link")))
            if world is None:
                continue
            x, y, z = (shape.get("pose") or [0, 0, 0])[:3]
            place = [world[i] * x + world[4 + i] * y + world[8 + i] * z + world[12 + i] for i in range(3)]
            self.assert_close(shape["at"], place, f"{whose}: a shape of {shape['entity']}, {shape.get('link')}")
        return len(worlds)


def distance(a, b):
    return math.dist(a[12:15], b[12:15])
