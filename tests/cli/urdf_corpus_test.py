# SPDX-License-Identifier: BSD-3-Clause
"""smurf2urdf exports every URDF of the corpus that urdfdom loads, and says why it refuses the others.

The tool proves each result (--prove): link poses, masses and limits are those of the source. What urdfdom says
is in MANIFEST.tsv, recorded with check_urdf. Prints how many files were exported and refused, and for what.

usage: urdf_corpus_test.py SMURF2URDF CORPUS; ends with 77, which CTest shows as skipped, without a corpus.
"""
import collections
import csv
import pathlib
import re
import subprocess
import sys

LEAST = 400  # URDFs in the corpus
LOSS = re.compile(r"cannot be converted: (.+?)(; see --force)?; nothing was written$")


def loaded_by_urdfdom(corpus):
    """{URDF: whether urdfdom loads it}"""
    with open(corpus / "MANIFEST.tsv", encoding="utf-8") as file:
        rows = csv.DictReader(file, delimiter="\t")
        return {corpus / row["path"]: row["check_urdf_rc"] == "0" for row in rows
                if row["path"].lower().endswith(".urdf") and row["check_urdf_rc"]}


def export(tool, urdf):
    """The reason of a refusal, or none; fails if the tool gives no reason."""
    done = subprocess.run([tool, str(urdf), "--dry-run", "--prove"], capture_output=True, encoding="utf-8",
                          errors="replace", timeout=120, check=False)
    if done.returncode == 0:
        proof = re.search(r"^compared \d+ links at 5 joint positions$", done.stderr, re.MULTILINE)
        return None if proof else "exported without a proof"
    lines = done.stderr.splitlines()
    reason = LOSS.search(lines[-1]) if done.returncode == 1 and lines else None
    return reason[1] if reason else f"exit code {done.returncode}: {done.stderr[-300:]}"


def main():
    tool, corpus = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    if not (corpus / "MANIFEST.tsv").is_file():
        print(f"skipped: there is no {corpus}")
        sys.exit(77)
    expected = loaded_by_urdfdom(corpus)
    failures, reasons = [], collections.Counter()
    for urdf, is_loaded in expected.items():
        reason = export(tool, urdf)
        reasons[reason or "exported"] += 1
        if reason is not None and (is_loaded or reason.startswith(("exit code", "exported without"))):
            failures.append(f"{urdf}: {reason}")
    for reason, count in reasons.most_common():
        print(f"{count:5} {reason}")
    if len(expected) < LEAST:
        failures.append(f"only {len(expected)} URDFs were tried")
    sys.exit("\n".join(failures) or 0)


if __name__ == "__main__":
    main()
