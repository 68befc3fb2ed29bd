# SPDX-License-Identifier: BSD-3-Clause
"""The page shows real robots and random nested scenes with the poses of the flat JSON, at random joint positions.

Usage: viewer_corpus_test.py TOOL BUILD
"""
import random
import subprocess
import unittest

import viewer
from viewer import READ, cli, set_positions

CORPUS = cli.ROOT.parent / "shared/corpus"
SMALL = {"width": 320, "height": 240}


class CorpusTest(viewer.ViewerTest):
    def robots(self, count):
        """URDFs that smurfs-flatten writes without an error, from as many repositories as possible."""
        files = sorted(CORPUS.glob("urdf/**/*.urdf"), key=lambda path: random.Random(str(path.relative_to(CORPUS))).random())
        for path in files:
            if count == 0:
                return
            done = subprocess.run([cli.TOOL, path, "--force", "--quiet", "--allow-outside"], capture_output=True, check=False)
            if done.returncode == 0:
                count -= 1
                yield path

    @unittest.skipUnless(CORPUS.is_dir(), "there is no corpus")
    def test_links_of_real_robots(self):
        robots, jobs = [], []
        for number, path in enumerate(self.robots(60)):
            page = self.page(path, f"{number}.html")
            data, _ = self.data(page)
            configurations = viewer.joint_configurations(data["models"][0], 5, str(number))
            instances = self.posed(path.read_bytes(), configurations)
            robots.append((path, data, instances))
            jobs.append({**SMALL, "page": page, "steps": [step for one in configurations
                                                         for step in (set_positions(0, one), READ)]})
        self.assertEqual(len(robots), 60)
        compared = 0
        for (path, data, instances), answer in zip(robots, self.browse(*jobs)):
            with self.subTest(path.relative_to(CORPUS)):
                for read, instance in zip(answer["results"][1::2], instances):
                    compared += self.assert_poses(read, data, [instance], path.name)
        print(f"{compared} poses of 60 robots agree")

    def test_random_nested_scenes(self):
        arm = cli.FIXTURES / "models/arm/smurf/arm.smurf"
        scenes = []
        for number in range(30):
            rng = random.Random(number)

            def entities(depth):
                made = []
                for index in range(rng.randint(1, 4)):
                    entity = {"name": f"e{index}", "position": [rng.uniform(-9, 9) for _ in range(3)],
                              "rotation": [rng.uniform(-180, 180) for _ in range(3)], "file": str(arm)}
                    if depth > 0 and rng.random() < 0.5:
                        inner = f"s{number}_{depth}_{index}.smurfs"
                        self.write(inner, viewer.json.dumps({"entities": entities(depth - 1)}))
                        entity["file"] = inner
                    above = [one["name"] for one in made if one["file"] == str(arm)]
                    if above and rng.random() < 0.6:
                        entity["parent"] = f"{rng.choice(above)}::{rng.choice(('forearm', 'hand', 'base_link'))}"
                        entity["anchor"] = rng.choice(("none", "parent"))
                    made.append(entity)
                return made

            self.write(f"s{number}.smurfs", viewer.json.dumps({"entities": entities(2)}))
            scenes.append(f"s{number}.smurfs")
        pages = [self.page(scene, f"{scene}.html") for scene in scenes]
        answers = self.browse(*({**SMALL, "page": page, "steps": [READ]} for page in pages))
        compared = 0
        for scene, page, answer in zip(scenes, pages, answers):
            with self.subTest(scene):
                instances = self.flat(scene)["instances"]
                compared += self.assert_poses(answer["results"][0], self.data(page)[0], instances, scene)
        print(f"{compared} poses of 30 nested scenes agree")


if __name__ == "__main__":
    viewer.main()
