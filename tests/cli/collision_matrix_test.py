# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lint --collision-matrix: pairs of links of which it is known whether they touch, and the SRDF that is written.

collision_matrix_test.py SMURF-LINT
"""
import xml.etree.ElementTree as ElementTree

import cli

LIMIT = '<limit lower="{}" upper="{}" effort="1" velocity="1"/>'


def link(name, shape="", at="0 0 0"):
    shape = f'<collision><origin xyz="{at}"/><geometry>{shape}</geometry></collision>' if shape else ""
    return f'<link name="{name}">{shape}</link>'


def box(*size):
    return f'<box size="{" ".join(map(str, size))}"/>'


def joint(name, parent, child, kind="fixed", at="0 0 0", axis="0 0 1", limits=(-1, 1)):
    bounds = LIMIT.format(*limits) if kind in ("revolute", "prismatic") else ""
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{at}"/>'
            f'<axis xyz="{axis}"/>{bounds}</joint>')


class CollisionMatrix(cli.CliTest):
    def matrix(self, *parts, arguments=()):
        """(link, link) -> reason, and standard error."""
        self.write("r.urdf", '<robot name="r &amp; d">' + "".join(parts) + "</robot>")
        done = self.run_tool("--collision-matrix", "r.urdf", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        root = ElementTree.fromstring(done.stdout)
        self.assertEqual(root.get("name"), "r & d")
        return {(one.get("link1"), one.get("link2")): one.get("reason")
                for one in root.iter("disable_collisions")}, done.stderr

    def arm(self, bend, arguments=()):
        """The forearm, 1 m long, folds about z towards a base that is 1 m away."""
        return self.matrix(link("base", box(0.2, 0.2, 0.2)), link("upper", box(0.9, 0.1, 0.1), "0.5 0 0"),
                           link("fore", box(0.9, 0.1, 0.1), "0.5 0 0"),
                           joint("shoulder", "base", "upper", "revolute"),
                           joint("elbow", "upper", "fore", "revolute", "1 0 0", limits=(-bend, bend)),
                           arguments=arguments)[0]

    def test_the_range_of_the_joints_decides(self):
        near = {("base", "upper"): "Adjacent", ("upper", "fore"): "Adjacent"}
        self.assertEqual(self.arm(2), {**near, ("base", "fore"): "Never"})
        self.assertEqual(self.arm(3.14), near)

    def test_samples(self):
        """With few samples, a rare contact is not found; the result is the same each time."""
        self.assertEqual(self.arm(3.14, ["--samples", "1"])["base", "fore"], "Never")
        self.assertEqual(self.arm(3.14, ["--samples", "3000"]), self.arm(3.14, ["--samples", "3000"]))
        done = self.run_tool("--collision-matrix", "r.urdf", "--samples", "0")
        self.assertEqual(done.returncode, 2, done.stdout)
        done = self.run_tool("r.urdf", "--samples", "5")
        self.assertIn("--samples needs --collision-matrix", done.stderr)

    def test_links_without_shapes_connect(self):
        found, _ = self.matrix(link("base", box(1, 1, 1)), link("flange"), link("hand", box(1, 1, 1)),
                               link("far", box(1, 1, 1)), joint("a", "base", "flange", at="0 0 5"),
                               joint("b", "flange", "hand", "continuous"), joint("c", "hand", "far", at="9 0 0"))
        self.assertEqual(found, {("base", "hand"): "Adjacent", ("hand", "far"): "Adjacent", ("base", "far"): "Never"})

    def test_at_the_start_and_always(self):
        """`cup` is around `base` at zero. `rod` enters it from 4 % of its way on. `lid` does so half of the time."""
        slide = {"kind": "prismatic", "axis": "0 0 -1", "limits": (0, 1)}
        found, _ = self.matrix(link("base", box(1, 1, 1)), link("arm", box(0.1, 0.1, 0.1)), link("cup", box(2, 2, 2)),
                               link("rod", box(0.1, 0.1, 3)), link("lid", box(0.1, 0.1, 3)),
                               joint("a", "base", "arm", at="0 0 20"), joint("b", "arm", "cup", at="0 0 -20"),
                               joint("c", "arm", "rod", at="0.3 0 -17.96", **slide),
                               joint("d", "arm", "lid", at="-0.3 0 -17.5", **slide))
        self.assertEqual(found, {("base", "arm"): "Adjacent", ("arm", "cup"): "Adjacent", ("arm", "rod"): "Adjacent",
                                 ("arm", "lid"): "Adjacent", ("base", "cup"): "Default", ("base", "rod"): "Always",
                                 ("cup", "rod"): "Default", ("cup", "lid"): "Default", ("rod", "lid"): "Never"})

    def test_followers_and_bounds(self):
        """The finger follows, so it never meets the thumb; a range without zero starts at its lower bound."""
        def hand(mimic):
            slide = '<limit lower="0.2" upper="1" effort="1" velocity="1"/>'
            return self.matrix(
                link("palm", box(0.1, 0.1, 0.1)), link("thumb", box(0.1, 0.1, 0.1)), link("finger", box(0.1, 0.1, 0.1)),
                '<joint name="t" type="prismatic"><parent link="palm"/><child link="thumb"/><axis xyz="1 0 0"/>' + slide +
                '</joint><joint name="f" type="prismatic"><parent link="palm"/><child link="finger"/>'
                '<origin xyz="0.15 0 0"/><axis xyz="1 0 0"/>' + slide + mimic + "</joint>")[0]

        self.assertEqual(hand('<mimic joint="t"/>').get(("thumb", "finger")), "Never")
        self.assertIsNone(hand("").get(("thumb", "finger")))

    def test_what_is_nearly_in_contact_is_kept(self):
        def apart(gap):
            return self.matrix(link("base"), link("a", '<sphere radius="0.5"/>'), link("b", '<sphere radius="0.5"/>'),
                               link("c", box(9, 9, 0.1), "0 0 20"), joint("ja", "base", "a", "continuous"),
                               joint("jc", "a", "c"), joint("jb", "c", "b", "continuous", f"{1 + gap} 0 0"))[0]

        self.assertEqual(apart(0.05)["a", "b"], "Never")
        self.assertNotIn(("a", "b"), apart(0.005))

    def test_what_is_not_known_is_left_out(self):
        found, said = self.matrix(link("base", box(1, 1, 1)), link("arm", box(1, 1, 1)), link("free", box(1, 1, 1)),
                                  link("mesh", '<mesh filename="absent.stl"/>'),
                                  joint("a", "base", "arm", at="9 0 0"), joint("b", "base", "mesh"),
                                  joint("c", "arm", "free", "floating"))
        self.assertEqual(found, {("base", "arm"): "Adjacent"})
        self.assertIn("1 link with shapes that cannot be read", said)
        self.assertIn("2 pairs on both sides of a floating or planar joint", said)

    def test_it_is_the_srdf_of_the_robot(self):
        """smurf-lint accepts it, and -o says what is in it."""
        self.arm(2)
        done = self.run_tool("--collision-matrix", "r.urdf", "-o", "r.srdf")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertIn("3 of 3 pairs of links need no check: 2 Adjacent, 0 Default, 0 Always, 1 Never", done.stderr)
        done = self.run_tool("r.srdf", "r.urdf")
        self.assertNotIn("SML35", done.stdout)


if __name__ == "__main__":
    cli.main()
