# SPDX-License-Identifier: BSD-3-Clause
"""Do two builds print, write and return the same?"""
import shutil

from builds import sum_of

MOST_SHOWN = 20


def written(folder, build):
    """The contents of a folder, which is then emptied."""
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            found[str(path.relative_to(folder))] = sum_of(build.shared(path.read_bytes()))
    for path in folder.iterdir():
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    return found


def show(native, other, job):
    """The differences, for debugging."""
    outputs = []
    for build in (native, other):
        done = build.run_alone(job)
        outputs.append([f"exit code {done.returncode}", *(done.stdout + done.stderr).decode(errors="replace").splitlines()])
    for lines in zip(*outputs):
        if lines[0] != lines[1]:
            print(f"    native {lines[0][:300]}\n    other  {lines[1][:300]}")
            return


def are_equal(native, other, jobs, scratch):
    """True if all jobs do the same; else the first differences are printed. Jobs may write to the folder `scratch`."""
    different = 0
    for job in jobs:
        expected = [native.run(job), written(scratch, native)]
        found = [other.run(job), written(scratch, other)]
        if expected == found:
            continue
        different += 1
        if different <= MOST_SHOWN:
            print("differs:", job[0], *job[1], "in", job[2])
            if expected[0] == found[0]:
                print("    in what was written:", expected[1], found[1])
            show(native, other, job)
            written(scratch, other)
    print(f"{len(jobs) - different} of {len(jobs)} runs are equal")
    return different == 0
