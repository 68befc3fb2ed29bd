#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of `smurfs-flatten --format html` in Chromium, which draws them without a graphics card.

pages.py SMURFS-FLATTEN   Size, time from opening to the first picture, and pictures a second while the camera turns
                          and while all joints move, of an arm, a model of 4,200 links and a scene of 100 robots of 40 links. Ends with
                          77 when Chromium, node or puppeteer-core is absent.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
MODULES = ROOT / "build/readers/node_modules"
# Draws a picture. Reading a pixel waits until it is finished.
DRAW = """const { stage, motion } = smurfViewer;
  const context = stage.renderer.getContext();
  const draw = () => {
    stage.renderer.render(stage.scene, stage.camera);
    context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
  };"""
# Milliseconds since the page was requested.
FIRST = f"(() => {{ {DRAW} draw(); return performance.now(); }})()"
# Repeatedly calls `step` and draws a picture, for three seconds. Returns the pictures per second.
RATE = DRAW + """
  const rate = (step) => {
    const start = performance.now();
    let pictures = 0;
    for (; performance.now() - start < 3000; pictures++) {
      step(pictures);
      draw();
    }
    return (1000 * pictures) / (performance.now() - start);
  };"""
# The camera turns before every picture.
TURNING = f"(() => {{ {RATE} return rate(() => stage.turn(0.02, 0)); }})()"
# Every joint moves before every picture.
MOVING = f"(() => {{ {RATE}" + """
  const joints = motion.scene.entities.map(({ model }) =>
    (model?.joints ?? []).filter(({ axis, leader }) => axis && leader === undefined).map(({ name }) => name));
  const pictures = rate((count) => {
    const position = 0.3 * Math.sin(count / 10);
    motion.positions = joints.map((names) => new Map(names.map((name) => [name, position])));
    motion.update();
    smurfViewer.move();
  });
  return [pictures, joints.flat().length];
})()"""
# title, input, goals: seconds to the first picture, pictures a second
INPUTS = [("arm", ROOT / "fixtures/models/arm/smurf/arm.smurf", None, None),
          ("4,200 links", ("model", "4200", "smurf/m.smurf"), 3, None),
          ("100 robots", ("scene", "100", "world.smurfs"), None, 30)]


def main():
    if shutil.which("chromium") is None or shutil.which("node") is None or not (MODULES / "puppeteer-core").is_dir():
        print("pages: Chromium, node or puppeteer-core is absent; scripts/setup --readers installs them")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for number, (title, source, seconds, rate) in enumerate(INPUTS):
            if isinstance(source, tuple):
                kind, size, file = source
                subprocess.run([sys.executable, HERE / "generate.py", kind, size, folder / kind], check=True)
                source = folder / kind / file
            page = folder / f"{number}.html"
            subprocess.run([sys.argv[1], source, "--format", "html", "--quiet", "-o", page], check=True)
            job = {"page": str(page), "steps": [FIRST, TURNING, MOVING]}
            done = subprocess.run(["node", ROOT / "tests/web/pages.mjs", MODULES, shutil.which("chromium")], check=True,
                                  input=json.dumps([job]), stdout=subprocess.PIPE, encoding="utf-8")
            first, turning, (moving, joints) = json.loads(done.stdout)[0]["results"]
            goals = [f"below {seconds} s"] * (seconds is not None) + [f"{rate} pictures/s"] * (rate is not None)
            print(f"{title:12} {page.stat().st_size / 1e6:5.2f} MB, first picture after {first / 1000:.2f} s, "
                  f"{turning:6.1f} pictures/s while the camera turns, {moving:6.1f} while {joints} joints move{' (goal: ' if goals else ''}"
                  f"{', '.join(goals)}{')' if goals else ''}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
