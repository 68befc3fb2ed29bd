#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Processor time of the language server for each key stroke, and its memory.

lsp_latency.py SMURF-LSP [EDITS [LINKS]]   p50 and p99 in ms over EDITS (1000) key strokes, in a model of 42 and one
                                           of 4,200 links, or only that of LINKS; each is checked and its findings
                                           told before the next one.
"""
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "lsp"))
import client  # noqa: E402

TARGETS = {42: 10, 4200: 100}  # links: ms


def processor_time(process):
    """Processor time of all threads, ms."""
    total = 0
    for task in pathlib.Path(f"/proc/{process.pid}/task").iterdir():
        total += int((task / "schedstat").read_text().split()[0])
    return total / 1e6


def memory(process):
    """Resident, MB."""
    for line in pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines():
        if line.startswith("VmRSS"):
            return int(line.split()[1]) / 1000
    return 0


def strokes(text, rng):
    """Types a digit after a random number, and deletes it again."""
    while True:
        at = rng.randrange(len(text))
        while not (text[at].isdigit() and text[at - 1] == "."):
            at = (at + 1) % len(text)
        yield at + 1, 0, rng.choice("0123456789")
        yield at + 1, 1, ""


def measure(tool, links, edits, folder):
    """Sorted times in ms of key strokes in the URDF; memory in MB after a tenth of them and at the end."""
    subprocess.run([sys.executable, HERE / "generate.py", "model", str(links), folder], check=True)
    urdf = folder / "urdf/m.urdf"
    server = client.Client(tool, [folder])
    server.open(urdf, language="xml")
    server.published(urdf)
    times = []
    early = 0
    places = strokes(server.texts[str(urdf)], random.Random(links))
    for number in range(edits):
        at, removed, typed = next(places)
        before = processor_time(server.process)
        server.edit(urdf, at, at + removed, typed)
        server.published(urdf)
        times.append(processor_time(server.process) - before)
        if number == edits // 10:
            early = memory(server.process)
    late = memory(server.process)
    server.stop()
    return sorted(times), early, late


def main():
    edits = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    wanted = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    for links, target in TARGETS.items():
        if wanted not in (0, links):
            continue
        with tempfile.TemporaryDirectory() as folder:
            times, early, late = measure(sys.argv[1], links, edits, pathlib.Path(folder))
        p50, p99 = (times[min(len(times) - 1, int(len(times) * share))] for share in (0.5, 0.99))
        print(f"{links} links: p50 {p50:.1f} ms, p99 {p99:.1f} ms (target {target} ms), "
              f"{early:.0f} MB, at the end {late:.0f} MB")


if __name__ == "__main__":
    main()
