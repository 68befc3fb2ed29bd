# SPDX-License-Identifier: BSD-3-Clause
"""Files that the playground unpacks, in node: equal names, too many files, and addresses with too many files.

usage: intake_test.py; skips without node.
"""
import pathlib
import shutil
import subprocess
import sys

PLAYGROUND = pathlib.Path(__file__).resolve().parent.parent.parent / "web/playground"
SCRIPT = """
const { unzip, zip } = await import(`file://${process.argv[1]}/zip.js`);
const { fromHash, toHash } = await import(`file://${process.argv[1]}/share.js`);
const { contentsOf } = await import(`file://${process.argv[1]}/intake.js`);
const one = new Uint8Array([1]);
const files = (count) => new Map(Array.from({ length: count }, (_, i) => [`f${i}`, one]));
const open = (zipped) => contentsOf([["robot.zip", { size: zipped.length, arrayBuffer: async () => zipped }]]);
const told = (promise) => promise.then((found) => (found.files ?? found).size, (error) => error.message);
const renamed = (zipped, from, to) => zipped.map((byte) => (byte === from ? to : byte));
const pair = zip(new Map([["?", one], ["!", one]]));
console.log(await told(open(zip(files(5000)))));
console.log(await told(open(zip(files(5001)))));
console.log(await told(open(zip(new Map([...files(5000), [".git/config", one]])))));
console.log(await told(open(renamed(pair, 33, 63))));
console.log(await told(open(zip(new Map([["./a", one], ["a", one]])))));
console.log(await told(unzip(zip(files(5001)), 1e9)));
console.log(await told(fromHash(await toHash(files(5000), []))));
console.log(await told(fromHash(await toHash(files(5001), []))));
"""
EXPECTED = """5000
it has more than 5,000 files
5000
it has two files named '?'
it has two files named 'a'
5001
5000
the address is damaged: a part of it may have been cut off
"""

if shutil.which("node") is None:
    sys.exit(77)
done = subprocess.run(["node", "--input-type=module", "-e", SCRIPT, PLAYGROUND], capture_output=True, text=True, check=False)
print(done.stdout, done.stderr)
sys.exit(0 if done.stdout == EXPECTED else 1)
