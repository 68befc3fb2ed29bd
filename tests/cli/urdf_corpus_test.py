# SPDX-License-Identifier: BSD-3-Clause
"""smurf2urdf exports every URDF of the corpus that urdfdom loads, and says why it refuses the others.

The tool proves each result (--prove): link poses, masses and limits are those of the source. What urdfdom says
is in MANIFEST.tsv, recorded with check_urdf. Prints how many files were exported and refused, and for what.

usage: urdf_corpus_test.py EXPORTS CORPUS    EXPORTS is written by export_pass.py
"""
import collections
import csv
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import exported  # noqa: E402

LEAST = 400  # URDFs in the corpus
LOSS = re.compile(r"cannot be converted: (.+?)(; see --force)?; nothing was written$")


def loaded_by_urdfdom(corpus):
    """{URDF: whether urdfdom loads it}"""
    with open(corpus / "MANIFEST.tsv", encoding="utf-8") as file:
        rows = csv.DictReader(file, delimiter="\t")
        return {corpus / row["path"]: row["check_urdf_rc"] == "0" for row in rows
                if row["path"].lower().endswith(".urdf") and row["check_urdf_rc"]}


def reason_of(done):
    """The reason of a refusal, or none."""
    if done["code"] == 0:
        proof = re.search(r"^compared \d+ links at 5 joint positions$", done["messages"], re.MULTILINE)
        return None if proof else "exported without a proof"
    lines = done["messages"].splitlines()
    reason = LOSS.search(lines[-1]) if done["code"] == 1 and lines else None
    return reason[1] if reason else f"exit code {done['code']}: {done['messages'][-300:]}"


def main():
    robots = exported.robots(sys.argv[1])
    expected = loaded_by_urdfdom(pathlib.Path(sys.argv[2]).resolve())
    failures, reasons = [], collections.Counter()
    proved = {robot.source: robot.runs["proved"] for robot in robots if robot.is_urdf}
    for urdf, is_loaded in expected.items():
        reason = reason_of(proved[urdf])
        reasons[reason or "exported"] += 1
        if reason is not None and (is_loaded or reason.startswith(("exit code", "exported without"))):
            failures.append(f"{urdf}: {reason}")
    for reason, count in reasons.most_common():
        print(f"{count:5} {reason}")
    if len(expected) < LEAST:
        failures.append(f"only {len(expected)} URDFs were tried")
    exported.end(failures)


if __name__ == "__main__":
    main()
