# SPDX-License-Identifier: BSD-3-Clause
"""Where the programs of a wheel come from. In this order, and it says which:

SMURF_PREBUILT   a folder with the programs, and with the Python modules that are to be installed, one for each CPython;
                 their manual pages and completions are in ../share
the release      the archive that releases.sha256 names for this version and system; SMURF_RELEASES is another place
                 that has it (a URL, file: too), SMURF_FROM_SOURCE=1 leaves it alone
the sources      compiled here, with CMake
"""
import hashlib
import io
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import urllib.request

from .project import ROOT, VIEWER, homepage, version

PROGRAMS = ("smurf-lint", "smurf-lsp", "smurf2urdf", "urdf2smurf", "smurfs-flatten", "smurf-diff", "smurf-view",
            "smurf", "smurf-load-check")
OPTIONAL = "smurf-load-check"  # needs a physics engine, which is not everywhere
MAIN = "smurf-lint"  # on Linux the program of most tools, which have links to it (tools/CMakeLists.txt)
PAGES = ("man/man1/{}.1", "bash-completion/completions/{}", "zsh/vendor-completions/_{}",
         "fish/vendor_completions.d/{}.fish")  # in the folder share
SUMS = pathlib.Path(__file__).with_name("releases.sha256")
MODULE = "_smurf" + (sysconfig.get_config_var("EXT_SUFFIX") or ".so")


class NoPrograms(Exception):
    """The reason why there are no programs."""


def gather(work):
    """Three dictionaries, the programs, the modules, and the pages of the folder share: contents by name."""
    programs, modules, pages = _find(work)
    missing = [name for name in PROGRAMS if name not in map(_plain, programs)]
    if missing == [OPTIONAL]:
        say(f"there is no {OPTIONAL} among them")
    elif missing:
        raise NoPrograms(f"there is no {' and no '.join(missing)} among them")
    return programs, modules, pages


def names_of_main(programs):
    """The other names of the program MAIN."""
    return [name for name, content in programs.items() if name != MAIN and content == programs.get(MAIN)]


def _plain(name):
    """The name of a program without what Windows adds."""
    return name.removesuffix(".exe")


def _find(work):
    prebuilt = os.environ.get("SMURF_PREBUILT")
    if prebuilt:
        say(f"takes the programs of SMURF_PREBUILT, {prebuilt}")
        return from_folder(pathlib.Path(prebuilt), pathlib.Path(prebuilt))
    archive = f"smurf-tools-{version()}-{system()}.tar.gz"
    known = dict(reversed(line.split()) for line in SUMS.read_text().splitlines() if line and line[0] != "#")
    if archive in known and not os.environ.get("SMURF_FROM_SOURCE"):
        return from_release(archive, known[archive])
    offered = ", ".join(sorted(name for name in known if f"-{version()}-" in name))
    reason = f"the release has no programs for {system()} (it has {offered})" if offered else "there is no release of it"
    return from_source(work, f"version {version()}: {reason}")


def say(text):
    print(f"smurf-tools: {text}", file=sys.stderr, flush=True)


def system():
    """Such as linux-x86_64 or win-amd64."""
    return sysconfig.get_platform()


def from_folder(folder, module_folder):
    names = [name + suffix for name in PROGRAMS for suffix in ("", ".exe")]
    programs = {name: (folder / name).read_bytes() for name in names if (folder / name).is_file()}
    modules = {file.name: file.read_bytes() for file in sorted(module_folder.glob("_smurf.*")) if is_module(file.name)}
    share = folder.parent / "share"
    return programs, modules, {page: (share / page).read_bytes() for page in pages_of(programs) if (share / page).is_file()}


def pages_of(programs):
    return [page.format(name) for name in programs for page in PAGES]


def is_module(name):
    return name.startswith("_smurf.") and name.endswith((".so", ".pyd"))


LARGEST = 200_000_000  # bytes of an archive of a release; they have a quarter of it


def from_release(archive, sum_):
    base = os.environ.get("SMURF_RELEASES") or f"{homepage()}/releases/download/v{version()}"
    url = f"{base.rstrip('/')}/{archive}"
    say(f"takes the programs of the release, {url}")
    try:
        with urllib.request.urlopen(url, timeout=60) as answer:
            content = answer.read(LARGEST + 1)
    except OSError as problem:
        raise NoPrograms(f"cannot download {url}: {problem}\n"
                         "SMURF_RELEASES=URL names another place that has it, SMURF_PREBUILT=FOLDER a folder with the "
                         "programs; SMURF_FROM_SOURCE=1 compiles them here") from problem
    if len(content) > LARGEST:
        raise NoPrograms(f"{url} is not what was released: it has more than {LARGEST} bytes. Nothing was installed")
    if hashlib.sha256(content).hexdigest() != sum_:
        raise NoPrograms(f"{url} is not what was released: its sha256 is {hashlib.sha256(content).hexdigest()}, not {sum_}. "
                         "Nothing was installed")
    with tarfile.open(fileobj=io.BytesIO(content)) as files:
        members = {pathlib.PurePosixPath(member.name): member for member in files if member.isfile() or member.issym()}
        # In the folder of the release: bin/NAME, python/NAME, share/FOLDER/FOLDER/NAME.
        places = {path: (path.parts[1], "/".join(path.parts[2:])) for path in members if len(path.parts) > 2}
        wanted = {"bin": lambda name: _plain(name) in PROGRAMS, "python": is_module, "share": pages_of(PROGRAMS).__contains__}
        taken = {place: members[path] for path, place in places.items() if place[0] in wanted and wanted[place[0]](place[1])}
        contents = {place: files.extractfile(member).read() for place, member in taken.items()}
    return tuple({name: content for (folder, name), content in contents.items() if folder == each} for each in wanted)


def from_source(work, reason):
    lacks = [tool for tool in ("cmake", "ninja") if shutil.which(tool) is None]
    if not any(shutil.which(compiler) for compiler in (os.environ.get("CXX") or "c++", "g++", "clang++")):
        lacks.append("a C++ compiler")
    packages = missing_packages()
    if packages:
        raise NoPrograms(f"{reason}, and to compile it needs packages that are not installed. Run this first:\n"
                         f"  sudo apt install {' '.join(packages)}")
    if lacks:
        raise NoPrograms(f"{reason}, and to compile it needs {' and '.join(lacks)}, which {'is' if len(lacks) == 1 else 'are'} "
                         "not here. The top of scripts/setup lists all that it needs; SMURF_PREBUILT=FOLDER takes the programs of a folder")
    say(f"compiles the programs ({reason}); this takes about ten minutes of processor time")
    build, stage = work / "build", work / "stage"
    has_headers = pathlib.Path(sysconfig.get_path("include"), "Python.h").is_file()
    options = {
        "CMAKE_BUILD_TYPE": "Release", "SMURF_STATIC": "ON", "SMURF_BUILD_TESTS": "OFF", "SMURF_PYTHON": sys.executable,
        "SMURF_PYTHON_DIR": "python", **({} if has_headers else {"SMURF_BUILD_PYTHON": "OFF"}),
    }
    run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *(f"-D{key}={value}" for key, value in options.items()))
    run("cmake", "--build", build)
    run("cmake", "--install", build, "--prefix", stage, "--strip")
    if not VIEWER.is_file() and not (build / "viewer/viewer.html").is_file():
        say("without the 3D page of smurf-view and --format html, because three.js could not be fetched; "
            "run scripts/viewer, then install again")
    return from_folder(stage / "bin", stage / "python/smurf")


def missing_packages():
    """Packages of Debian and Ubuntu that compiling needs and that are not installed; nothing on other systems."""
    if shutil.which("dpkg-query") is None or shutil.which("bash") is None or not (ROOT / "scripts/setup").exists():
        return []
    asked = subprocess.run(["bash", ROOT / "scripts/setup", "--tools", "--print"], stdout=subprocess.PIPE, text=True, check=False)
    return asked.stdout.split() if asked.returncode == 0 else []


def run(*command):
    done = subprocess.run([str(part) for part in command], stdout=sys.stderr, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise NoPrograms(f"cannot be compiled here:\n{done.stderr.strip()}\n"
                         "scripts/setup installs what is needed on Debian and Ubuntu; SMURF_PREBUILT=FOLDER takes the "
                         "programs of a folder")
