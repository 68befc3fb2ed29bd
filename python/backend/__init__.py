# SPDX-License-Identifier: BSD-3-Clause
"""Makes the wheel of smurf-tools (PEP 517): the programs, `python -m smurf`, and the Python module where it was built.

Writes to temporary folders and to the folder that it is given.
"""
import contextlib
import pathlib
import subprocess
import sys
import tempfile

# No bytecode among the sources of somebody else: not of what follows, and that of this file is there already.
if not sys.dont_write_bytecode:
    sys.dont_write_bytecode = True
    with contextlib.suppress(OSError):
        pathlib.Path(__cached__).unlink()
        pathlib.Path(__cached__).parent.rmdir()

from .archives import write_sdist, write_wheel  # noqa: E402
from .elf import tag_of  # noqa: E402
from .programs import MAIN, MODULE, NoPrograms, gather, names_of_main  # noqa: E402
from .project import ROOT, VIEWER, metadata, stem  # noqa: E402


# A wheel has no symbolic links. pip replaces the first line by the path of the interpreter.
LINK = f"""#!python
import os, sys
os.execv(os.path.join(os.path.dirname(os.path.realpath(__file__)), "{MAIN}"), sys.argv)
""".encode()


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory(prefix="smurf-wheel-") as work:
        try:
            programs, modules, pages = gather(pathlib.Path(work))
        except NoPrograms as problem:
            sys.exit(f"smurf-tools: {problem}")
    tag = tag_of([*programs.values(), *modules.values()], list(modules) == [MODULE])
    programs |= dict.fromkeys(names_of_main(programs), LINK)
    print(f"smurf-tools: the wheel is for {tag}", file=sys.stderr)
    name = stem()
    suffixes = (".py", ".pyi", ".typed") if modules else (".py",)  # types are those of the module
    sources = [file for file in (ROOT / "python/smurf").iterdir() if file.suffix in suffixes]
    files = {f"smurf/{source.name}": source.read_bytes() for source in sources}
    files |= {f"smurf/{module}": content for module, content in modules.items()}
    files |= {f"{name}.data/scripts/{program}": content for program, content in programs.items()}
    files |= {f"{name}.data/data/share/{page}": content for page, content in pages.items()}
    files |= _dist_info(tag, bool(modules))
    wheel = pathlib.Path(wheel_directory, f"{name}-{tag}.whl")
    write_wheel(wheel, files, record=f"{name}.dist-info/RECORD")
    return wheel.name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    for name, content in _dist_info("py3-none-any").items():
        file = pathlib.Path(metadata_directory, name)
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(content)
    return f"{stem()}.dist-info"


def _dist_info(tag, has_module=True):
    python, abi, platforms = tag.split("-")
    tags = "".join(f"Tag: {python}-{abi}-{platform}\n" for platform in platforms.split("."))
    texts = {
        "LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8"),
        "METADATA": metadata(has_module),
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: smurf-tools\nRoot-Is-Purelib: false\n{tags}",
    }
    return {f"{stem()}.dist-info/{name}": text.encode() for name, text in texts.items()}


def build_sdist(sdist_directory, config_settings=None):
    """All files that git knows, as they are in the folder, and the 3D page, which is made with packages from the network."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, stdout=subprocess.PIPE, check=True).stdout.decode()
    files = {name: ROOT / name for name in listed.split("\0") if name and (ROOT / name).is_file()}
    if VIEWER.is_file():
        files[VIEWER.relative_to(ROOT).as_posix()] = VIEWER
    else:
        print("smurf-tools: without the 3D page; scripts/viewer makes it", file=sys.stderr)
    sdist = pathlib.Path(sdist_directory, f"{stem()}.tar.gz")
    write_sdist(sdist, stem(), files, metadata())
    return sdist.name
