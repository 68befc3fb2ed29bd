# SPDX-License-Identifier: BSD-3-Clause
"""Tests walking through the scene of a page, with keys alone and with the mouse.

Usage: walk_test.py TOOL BUILD
"""
import math

import viewer
from viewer import cli

ARM = cli.FIXTURES / "models/arm/urdf/arm.urdf"
CAMERA = "[...smurfViewer.stage.camera.position, ...smurfViewer.stage.direction().negate().normalize()]"
MOVES = "!smurfViewer.walk.isMoving"
STATE = ("[smurfViewer.walk.isOn, smurfViewer.stage.controls.enabled, document.getElementById('walk').getAttribute('aria-pressed'),"
         " document.getElementById('message').hidden ? '' : document.getElementById('message').textContent]")


def hold(key, changes, *with_keys):
    """Holds a key until the camera has moved, or turned, far enough."""
    return [f"smurfViewer.before = {CAMERA}", *({"down": each} for each in with_keys), {"down": key},
            {"until": f"(({CAMERA}).some((value, i) => Math.abs(value - smurfViewer.before[i]) > {changes}))"}, {"up": key},
            *({"up": each} for each in with_keys), {"until": MOVES}, f"[smurfViewer.before, {CAMERA}]"]


class WalkTest(viewer.ViewerTest):
    def test_keys_walk_turn_and_stop(self):
        parts = {"w": hold("w", 0.05), "d": hold("d", 0.05), "s": hold("s", 0.05), "a": hold("a", 0.05),
                 "up": hold("ArrowUp", 0.05), "down": hold("ArrowDown", 0.05), "left": hold("ArrowLeft", 0.1),
                 "right": hold("ArrowRight", 0.1), "look": hold("PageDown", 0.1), "steep": hold("PageUp", 0.3)}
        steps = [STATE, {"key": "w"}, STATE, "document.activeElement.id"]
        places = {}
        for name, part in parts.items():
            steps += part
            places[name] = len(steps) - 1
        steps += [{"axe": True}, {"key": "Escape"}, STATE, CAMERA, {"key": "ArrowLeft"}, CAMERA, "location.hash"]
        results = self.browse({"page": self.page(ARM), "steps": steps})[0]["results"]
        self.assertEqual(results[0], [False, True, "false", ""])
        self.assertEqual(results[2][:3], [True, False, "true"])
        for word in ("W A S D", "arrows", "Shift", "Escape"):
            self.assertIn(word, results[2][3])
        self.assertEqual(results[3], "stage")
        for name, expected in (("w", 0), ("up", 0), ("s", math.pi), ("down", math.pi), ("d", -math.pi / 2), ("a", math.pi / 2)):
            before, after = results[places[name]]
            way = [b - a for a, b in zip(before[:3], after[:3])]
            self.assertEqual(way[2], 0, f"{name} keeps the height")
            angle = math.atan2(way[1], way[0]) - math.atan2(before[4], before[3])
            self.assertAlmostEqual(math.cos(angle - expected), 1, 9, name)
            for a, b in zip(before[3:], after[3:]):
                self.assertAlmostEqual(a, b, 9)
        for name, sign in (("left", 1), ("right", -1)):
            before, after = results[places[name]]
            self.assertEqual(before[:3], after[:3])
            self.assertAlmostEqual(before[5], after[5], 9)
            self.assertGreater(sign * math.sin(math.atan2(after[4], after[3]) - math.atan2(before[4], before[3])), 0.05)
        for name, sign in (("look", -1), ("steep", 1)):
            before, after = results[places[name]]
            self.assertEqual(before[:3], after[:3])
            self.assertGreater(sign * (after[5] - before[5]), 0.05)
        axe, _, state, camera, _, turned, address = results[-7:]
        self.assertEqual(axe, [])
        self.assertEqual(state, [False, True, "false", ""])
        self.assertNotEqual(camera[:3], turned[:3])  # the arrows turn around the scene again
        self.assertIn("camera=", address)

    def test_shift_is_faster_and_dragging_looks_around(self):
        # The time between two pictures is fixed, so the speed of the computer does not matter.
        walked = """((fast) => {
          const { walk, stage } = smurfViewer;
          const from = stage.camera.position.clone();
          const now = performance.now;
          performance.now = () => 1000;
          walk.isMoving = true; // nothing else moves it
          walk.press({ code: "KeyW", shiftKey: fast });
          walk.before = 950;
          walk.step();
          walk.held.clear();
          performance.now = now;
          return from.distanceTo(stage.camera.position) / stage.radius;
        })"""
        steps = [{"key": "w"}, f"{walked}(false)", f"{walked}(true)", {"until": MOVES}, CAMERA, {"drag": [600, 400, 700, 420]}, CAMERA,
                 "document.getElementById('walk').click()", STATE, CAMERA, {"key": "w"}, {"key": "f"}, STATE,
                 {"key": "w"}, {"down": "w"}, {"until": "smurfViewer.walk.isMoving"}, "window.dispatchEvent(new Event('blur'))",
                 {"until": MOVES}, {"up": "w"}, {"key": "c"}, "document.getElementById('collisions').getAttribute('aria-pressed')"]
        results = self.browse({"page": self.page(ARM), "steps": steps})[0]["results"]
        self.assertAlmostEqual(results[1], 0.35 * 0.05, 9)
        self.assertAlmostEqual(results[2], 3 * 0.35 * 0.05, 9)
        before, after = results[4], results[6]
        self.assertEqual(before[:3], after[:3])
        self.assertAlmostEqual(math.atan2(after[4], after[3]) - math.atan2(before[4], before[3]), 0.4, 6)
        self.assertAlmostEqual(math.asin(after[5]) - math.asin(before[5]), 0.08, 6)
        self.assertEqual(results[8][:3], [False, True, "false"])
        for a, b in zip(after, results[9]):  # leaving it keeps the view
            self.assertAlmostEqual(a, b, 9)
        self.assertEqual(results[12][:3], [False, True, "false"])
        self.assertEqual(results[-1], "true")


if __name__ == "__main__":
    viewer.main()
