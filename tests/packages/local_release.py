# SPDX-License-Identifier: BSD-3-Clause
"""A copy of the files that pip needs, and a release for it in a local folder."""
import hashlib
import pathlib
import re
import shutil
import sysconfig
import tarfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAMS = ("smurf-lint", "smurf-lsp", "smurf2urdf", "urdf2smurf", "smurfs-flatten", "smurf-diff", "smurf-view",
            "smurf", "smurf-load-check")


def copy_of_project(folder):
    for name in ("pyproject.toml", "CMakeLists.txt", "README.md", "LICENSE", ".pre-commit-hooks.yaml"):
        shutil.copy(ROOT / name, folder)
    for name in ("python/backend", "python/smurf"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))


def add_release(project, folder, programs, system=sysconfig.get_platform()):
    """An archive in `folder` of the programs of another archive; the project contains its sum."""
    version = re.search(r"\n  VERSION (\S+)", (project / "CMakeLists.txt").read_text())[1]
    archive = folder / f"smurf-tools-{version}-{system}.tar.gz"
    with tarfile.open(archive, "w:gz", compresslevel=1) as files:
        for program in PROGRAMS:
            if (programs / program).exists():
                files.add(programs / program, f"smurf-tools-{version}/bin/{program}")
        if (programs.parent / "share").is_dir():
            files.add(programs.parent / "share", f"smurf-tools-{version}/share")
    with open(project / "python/backend/releases.sha256", "a", encoding="utf-8") as table:
        table.write(f"{hashlib.sha256(archive.read_bytes()).hexdigest()}  {archive.name}\n")
    return archive
