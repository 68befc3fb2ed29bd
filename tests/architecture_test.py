#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The stages of libsmurf: which may include which, and what must not be in the library.

Prints one line per violation, `file:line: what`; the exit code is 1 if there is any.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "libsmurf" / "src"
PUBLIC = ROOT / "libsmurf" / "include" / "smurf"
ROOMS = ["python", "tests", "tools", "web"]  # besides the stages

# Each stage and the stages whose private headers it may include besides its own: some of those before it in the
# orders of docs/architecture.md. Public headers may be those of all stages before it.
STAGES = {
    "base": set(),
    "archive": {"base"},
    "syntax": {"base"},
    "xacro": {"base", "syntax"},
    "imports": {"base", "syntax", "xacro"},
    "mjcf": {"base", "syntax", "xacro", "imports", "mesh"},
    "sdf": {"base", "syntax", "xacro", "imports", "mesh"},
    "ast": {"base", "syntax"},
    "mesh": {"base", "syntax"},
    "schema": {"base", "syntax", "ast"},
    "link": {"base", "archive", "syntax", "xacro", "imports", "mjcf", "sdf", "ast", "mesh"},
    "verdict": {"base"},
    "readers": {"base", "ast", "link"},
    "lint": {"base", "verdict", "ast", "link", "readers"},
    "config": {"base", "syntax", "ast"},
    "plan": {"base", "syntax", "xacro", "imports", "mjcf", "sdf", "ast", "link", "config"},
    "check": {"base", "verdict", "syntax", "xacro", "imports", "link", "lint", "config", "plan"},
    "flatten": {"base", "syntax", "ast", "link"},
    "convert": {"base", "syntax", "ast", "link"},
    "write": {"base", "archive", "syntax", "ast", "mesh", "link", "lint", "flatten", "convert"},
    "conversion": {"base", "verdict", "syntax", "mesh", "link", "lint", "check", "flatten", "convert", "write", "render"},
    "render": {"base", "verdict"},
    "diff": {"base", "syntax", "ast", "link", "write", "render"},
}

# The stage of each public header.
HEADERS = {
    "base": "diagnostic file_reader findings fix flat_shape limits names new_model pose readers source",
    "verdict": "verdict",
    "archive": "archive_files",
    "syntax": "xml yaml",
    "xacro": "xacro",
    "ast": "model scene srdf surroundings urdf",
    "mesh": "mesh mesh_triangles",
    "imports": "",
    "mjcf": "",
    "sdf": "",
    "schema": "user_schemas",
    "link": "companions linked load old_scene references rename",
    "readers": "joint_order",
    "render": "render",
    "lint": "lint",
    "config": "config",
    "plan": "confine found_inputs plan",
    "check": "check each",
    "flatten": "dialect flatten",
    "convert": "convert",
    "write": "write write_scene",
    "conversion": "asset_copies conversion result_losses",
    "diff": "diff",
}
STAGE_OF_HEADER = {f"{name}.hpp": stage for stage, names in HEADERS.items() for name in names.split()}

# Third-party headers by their first folder or name, and the stages that know them.
THIRD_PARTY = {
    "yaml-cpp": {"syntax"},
    "tinyxml2.h": {"syntax"},
    "minizip": {"archive"},
    "zlib.h": {"archive"},
    "nlohmann": {"mesh", "render", "write"},
    "Eigen": set(STAGES),
    "urdf_parser": {"convert"},
    "urdf_model": {"convert"},
    "urdf_world": {"convert"},
    "urdf_exception": {"convert"},
    "console_bridge": {"convert"},
    "tinyxml.h": {"convert"},
}
STAGE_PRIVATE = {"Eigen"}  # not in a header that another stage includes

PRINTING = re.compile(
    r"#include\s*<(iostream|cstdio|stdio\.h)>|\b(printf|fprintf|puts|putchar|perror)\s*\(|"
    r"\bstd::(cout|cerr|clog)\b"
)
# The only file that prints into a text, which the test of base/numbers/floating.hpp compares with the standard library.
PRINTS_INTO_TEXT = SOURCE / "base/numbers/portable_floating.cpp"
# Features that the libc++ of Emscripten lacks, or that C libraries round differently, and their replacements.
UNPORTABLE = {
    re.compile(r"\bstd::ranges::"): "base/ranges.hpp",
    re.compile(r"\bstd::bit_cast\b"): "base/numbers/bits.hpp",
    re.compile(r"\bstd::jthread\b"): "check/parallel.hpp",
    re.compile(r"\bstd::(sin|cos|tan|asin|acos|atan|atan2|hypot)\("): "base/numbers/exact_math.hpp",
    re.compile(r"\bstd::chars_format\b"): "base/numbers/floating.hpp",
}
REPLACEMENTS = {"base/ranges.hpp", "base/numbers/bits.hpp", "base/numbers/exact_math.hpp", "base/numbers/exact_math.cpp", "base/numbers/floating.cpp"}
# Headers of a system, and the only files that include them. std::filesystem behaves differently on Windows than
# base/files/places.hpp.
SYSTEM_HEADERS = re.compile(r"(dirent|fcntl|io|link|poll|shellapi|signal|spawn|unistd|windows|winioctl|winsock2)\.h|(linux|netinet|sys)/.*\.h|filesystem")
SYSTEM_FILES = re.compile(r"src/base/files/(places_posix\.cpp|system(_posix|_windows)?\.[ch]pp|windows_paths\.cpp)|"
                          r"tools/(common/cli/(process|browser)|smurf-view/sockets)_(posix|windows)\.cpp|tools/smurf-load-check/")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
LONGEST_FILE = 500

# Rules are run, places named and comments applied in one place, so that all tools judge a model in the same way.
PIPELINE = re.compile(r"\b(lint_model|lint_scene|locate|apply_targets)\s*\(|\b(Suppressions|Baseline)\b")
PIPELINE_FOLDERS = [SOURCE / "check", SOURCE / "lint", SOURCE / "verdict"]
# Private headers that tools include, and users of the library do not need. The list should get shorter.
PRIVATE_HEADERS_OF_TOOLS = {
    "ast/format.hpp",
    "config/companion_help.hpp",
    "config/key_help.hpp",
    "link/describe.hpp",
    "link/extension_names.hpp",
    "link/surroundings/wanted_names.hpp",
    "lint/inertia_repair.hpp",
    "link/collision_matrix.hpp",
    "lint/masses.hpp",
    "lint/suppress.hpp",
    "plan/launched_values.hpp",
    "plan/models_around.hpp",
    "plan/repository.hpp",
    "plan/robots_around.hpp",
    "plan/shared_files.hpp",
    "plan/xacro_files.hpp",
    "plan/xacro_text.hpp",
    "base/text/counted.hpp",
    "base/text/did_you_mean.hpp",
    "base/text/edits.hpp",
    "base/text/lists.hpp",
    "base/deadline.hpp",
    "base/findings/limits.hpp",
    "base/numbers/numbers.hpp",
    "base/files/descriptor.hpp",
    "base/files/path.hpp",
    "base/files/places.hpp",  # differences between systems are in this file
    "base/text/quoted.hpp",
    "base/findings/rules.hpp",
    "base/sanitizer.hpp",
    "base/text/suggest.hpp",
    "base/files/system.hpp",
    "base/files/uri.hpp",
    "base/text/utf8.hpp",
    "base/text/words.hpp",
    "base/files/windows_paths.hpp",
    "convert/mass_properties.hpp",
    "flatten/scene_shapes.hpp",
    "link/kinematics.hpp",
    "lint/annotation_queries.hpp",
    "link/inertia.hpp",
    "link/package_manifest.hpp",
    "lint/queries.hpp",
    "render/advice.hpp",
    "render/json_text.hpp",
    "render/printable.hpp",
    "render/wrap.hpp",
    "write/text/json_text.hpp",
    "xacro/seen_arguments.hpp",
}


# Tables with one file for each row, the folders of the files, and the namespaces around those of the files.
FILES_OF_TABLES = {
    "base/findings/rules.def": ("lint/rules", "smurf::rules"),
    "ast/sections.def": ("ast/sections", "smurf::sections"),
    "base/findings/readers.def": ("readers", "smurf::readers"),
    "flatten/dialects.def": ("flatten/dialects", "smurf::readings"),
    "write/scene_formats.def": ("write", "smurf"),
}


def code_lines(path):
    """Lines without // comments, with their numbers."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        yield number, re.sub(r"//.*", "", line)


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in {".cpp", ".hpp", ".def"})


def is_standard(header):
    return "/" not in header and "." not in header or SYSTEM_HEADERS.fullmatch(header)


def written_orders():
    """The stages before each stage, from lines such as `base < {archive, syntax} < link` in docs/architecture.md."""
    before = {stage: set() for stage in STAGES}
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    for order in re.findall(r"`([\w{}, ]+(?: < [\w{}, ]+)+)`", page):
        steps = [re.findall(r"\w+", step) for step in order.split(" < ")]
        for earlier, later in zip(steps, steps[1:]):
            for stage in later:
                before[stage].update(earlier)
    for _ in STAGES:
        for stage in before:
            before[stage].update(*(before[earlier] for earlier in before[stage]))
    return before


BEFORE = written_orders()


def check_orders():
    """The orders have no cycle, and hold for what a stage may include."""
    for stage, earlier in BEFORE.items():
        for other in sorted(STAGES[stage] - earlier | ({stage} & earlier)):
            yield ROOT / "docs" / "architecture.md", 1, f"{other} is not before {stage}, or {stage} is before itself"


def check_include(path, stage, bracket, header):
    """An error message about an include of a file in a stage; empty if there is none."""
    first = header.split("/")[0]
    if bracket == '"' or first in STAGES:
        if first in STAGES:
            is_allowed = first == stage or first in STAGES[stage]
            return "" if is_allowed else f"{stage} must not include {header}"
        return "" if first == "smurf" else f"{header} names no stage"
    if first in THIRD_PARTY:
        if stage not in THIRD_PARTY[first]:
            return f"{stage} must not know {first}"
        return ""
    if is_standard(header):
        return ""
    return f"<{header}> is unknown here; name its stages in {pathlib.Path(__file__).name}"


def check_private_headers():
    """Headers of libraries that belong to one stage must not be included by another stage through its headers."""
    holders = {}
    for path in sources(SOURCE):
        for number, line in code_lines(path):
            include = INCLUDE.match(line)
            if path.suffix == ".hpp" and include and include[2].split("/")[0] in STAGE_PRIVATE:
                holders[str(path.relative_to(SOURCE))] = include[2]
    for path in sources(SOURCE):
        for number, line in code_lines(path):
            include = INCLUDE.match(line)
            if not include or include[2] not in holders:
                continue
            if include[2].split("/")[0] != path.relative_to(SOURCE).parts[0]:
                yield path, number, f"{include[2]} brings {holders[include[2]]} to another stage"


def check_stage_files():
    for path in sources(SOURCE):
        stage = path.relative_to(SOURCE).parts[0]
        if stage not in STAGES:
            yield path, 1, f"the folder {stage} is no stage"
            continue
        for number, line in code_lines(path):
            if PRINTING.search(line) and path != PRINTS_INTO_TEXT:
                yield path, number, "the library prints nothing"
            include = INCLUDE.match(line)
            if include and (fault := check_include(path, stage, *include.groups())):
                yield path, number, fault


def check_portable():
    for path in sources(SOURCE):
        if str(path.relative_to(SOURCE)) in REPLACEMENTS:
            continue
        for number, line in code_lines(path):
            for pattern, replacement in UNPORTABLE.items():
                if found := pattern.search(line):
                    yield path, number, f"{found[0]} differs between systems; {replacement} does the same everywhere"


def check_systems():
    """Differences between systems are in few files."""
    for path in [*sources(SOURCE), *sources(ROOT / "tools")]:
        for number, line in code_lines(path):
            include = INCLUDE.match(line)
            if include and SYSTEM_HEADERS.fullmatch(include[2]) and not SYSTEM_FILES.search(path.as_posix()):
                yield path, number, f"<{include[2]}> is for base/files/system.hpp and base/files/places.hpp"


def check_public_headers():
    for path in sources(PUBLIC):
        for number, line in code_lines(path):
            if PRINTING.search(line):
                yield path, number, "the library prints nothing"
            include = INCLUDE.match(line)
            if not include:
                continue
            bracket, header = include.groups()
            is_own = bracket == '"' and header.startswith("smurf/") and header.count("/") == 1
            if not is_own and not (bracket == "<" and "/" not in header and "." not in header):
                yield path, number, f"a public header includes {header}"


def check_stages_of_headers():
    """The order of the stages holds for public headers as well."""
    for path in [*sources(PUBLIC), *sources(SOURCE)]:
        stage = STAGE_OF_HEADER.get(path.name) if PUBLIC in path.parents else path.relative_to(SOURCE).parts[0]
        if stage is None:
            yield path, 1, "this header is in no stage of HEADERS"
            continue
        for number, line in code_lines(path):
            include = INCLUDE.match(line)
            if not include or not include[2].startswith("smurf/"):
                continue
            name = include[2].removeprefix("smurf/")
            other = STAGE_OF_HEADER.get(name)
            if other is not None and other != stage and other not in BEFORE[stage]:
                yield path, number, f"{stage} must not include {include[2]}, which belongs to {other}"


def check_maps():
    """The README.md of each room, and the map of all, name files that exist."""
    rooms = [*(SOURCE / stage / "README.md" for stage in STAGES), *(ROOT / room / "README.md" for room in ROOMS)]
    for page in [*rooms, ROOT / "docs" / "architecture.md"]:
        if not page.exists():
            yield page, 1, "this room has no README.md"
            continue
        for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
            for name in re.findall(r"`([\w./*-]+\.(?:cpp|hpp|def|py|js|mjs|ts|cmake))`", line):
                pattern = re.sub(r"NNNN?_name|NNNN?|NAME", "*", name)
                starts = (ROOT / "libsmurf", ROOT / "libsmurf/include", ROOT)
                if not any(page.parent.rglob(pattern)) and not any(any(start.glob(pattern)) for start in starts):
                    yield page, number, f"there is no {name}"


def check_installed_headers():
    """A header that is not in the list is not installed."""
    listed = (ROOT / "libsmurf" / "CMakeLists.txt").read_text(encoding="utf-8").split()
    for path in sources(PUBLIC):
        if path.name not in listed:
            yield path, 1, "this header is not in public_headers of libsmurf/CMakeLists.txt"


def check_namespaces():
    """Files of tables are compiled as one unit, and their helpers have the same names."""
    for table, (folder, namespace) in FILES_OF_TABLES.items():
        for row in re.findall(r"^SMURF_\w+\((\w+)\)", (SOURCE / table).read_text(encoding="utf-8"), re.M):
            path = SOURCE / folder / f"{row}.cpp"
            expected = f"namespace {namespace}::{row}_file {{"
            if path.exists() and expected not in path.read_text(encoding="utf-8").splitlines():
                yield path, 1, f"write `{expected}`, so that other files may use the same names"


def check_pipeline():
    for path in sorted(p for folder in (SOURCE, ROOT / "tools") for p in sources(folder)):
        if any(folder in path.parents for folder in PIPELINE_FOLDERS):
            continue
        for number, line in code_lines(path):
            if found := PIPELINE.search(line):
                yield path, number, f"{found[0].strip('(')} is called by the stage check alone"


def check_tools():
    """Tools include public headers only."""
    unused = set(PRIVATE_HEADERS_OF_TOOLS)
    for path in sources(ROOT / "tools"):
        for number, line in code_lines(path):
            include = INCLUDE.match(line)
            if not include or include[2].split("/")[0] not in STAGES:
                continue
            unused.discard(include[2])
            if include[2] not in PRIVATE_HEADERS_OF_TOOLS:
                yield path, number, f"{include[2]} is private to the library"
    for header in sorted(unused):
        yield pathlib.Path(__file__).resolve(), 1, f"no tool includes {header}; take it out of the list"


def check_sizes():
    folders = [ROOT / "libsmurf", ROOT / "tools"]
    for path in sorted(p for folder in folders for p in sources(folder)):
        size = len(path.read_text(encoding="utf-8").splitlines())
        if size > LONGEST_FILE and path.suffix != ".def":  # a row a line
            yield path, size, f"{size} lines; split it below {LONGEST_FILE}"


def check_types():
    """Two types of one name in one namespace break each other: the linker takes the functions of one of them for both."""
    first = {}
    for path in sorted(p for folder in (SOURCE, PUBLIC, ROOT / "tools") for p in sources(folder)):
        spaces = []
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if space := re.match(r"namespace ?([\w:]*) ?\{", line):
                spaces.append(space[1])
            elif line.startswith("}  // namespace") and spaces:
                spaces.pop()
            elif (kind := re.match(r"(?:struct|class) (\w+)(?: final)?(?: :.*)?\s*\{", line)) and "" not in spaces:
                name = "::".join([*spaces, kind[1]])
                if first.setdefault(name, path) != path:
                    yield path, number, f"{name} is also a type in {first[name].relative_to(ROOT)}"


def main():
    faults = [
        *check_orders(),
        *check_stage_files(),
        *check_portable(),
        *check_systems(),
        *check_private_headers(),
        *check_public_headers(),
        *check_stages_of_headers(),
        *check_maps(),
        *check_installed_headers(),
        *check_namespaces(),
        *check_pipeline(),
        *check_tools(),
        *check_sizes(),
        *check_types(),
    ]
    for path, number, fault in faults:
        print(f"{path.relative_to(ROOT)}:{number}: {fault}")
    checked = len(sources(SOURCE)) + len(sources(PUBLIC))
    if checked < 50:
        print(f"only {checked} files were found; has the library moved?")
        return 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
