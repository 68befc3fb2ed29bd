# SPDX-License-Identifier: BSD-3-Clause
"""package.xml names what CMake looks for; scripts/setup, Debian's packages and the recipes name what package.xml names.

usage: package_xml_test.py            compares
       package_xml_test.py --debian   prints the Debian packages of all names in package.xml, for tests/packages/colcon_build
"""
import pathlib
import re
import sys
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BUILT = ("CMakeLists.txt", "libsmurf/CMakeLists.txt", "tools/CMakeLists.txt", "python/CMakeLists.txt")
# Names in package.xml for the packages that CMake looks for: keys of rosdep if they exist.
NAMES = {
    "yaml-cpp": {"yaml-cpp"}, "tinyxml2": {"tinyxml2"}, "Eigen3": {"eigen"}, "nlohmann_json": {"nlohmann-json-dev"},
    "urdfdom": {"liburdfdom-dev", "liburdfdom-headers-dev"}, "console_bridge": {"libconsole-bridge-dev"},
    "PkgConfig": {"pkg-config"}, "minizip": {"libminizip-dev"}, "ZLIB": {"zlib"}, "ode": {"opende"}, "PNG": {"libpng-dev"},
    "pybind11": {"pybind11-dev", "python3-dev", "python3"}, "Threads": set(),
}
NAMES_OF_TESTS = {"doctest": {"doctest-dev"}, "assimp": {"assimp-dev"}, "Python3": {"python3", "python3-jsonschema"}}
# Debian packages whose names differ from those.
DEBIAN = {
    "yaml-cpp": "libyaml-cpp-dev", "tinyxml2": "libtinyxml2-dev", "eigen": "libeigen3-dev",
    "nlohmann-json-dev": "nlohmann-json3-dev", "opende": "libode-dev", "zlib": "zlib1g-dev", "assimp-dev": "libassimp-dev",
}
KINDS = ("depend", "build_depend", "exec_depend")


def looked_for(file, also_optional):
    """The packages that the find commands of a CMake file look for."""
    text = (ROOT / file).read_text()
    found = re.findall(r"find_package\((\w[\w-]*)([^)]*)\)", text)
    found += re.findall(r"pkg_check_modules\(\w+([^)]*?) ([\w-]+)\)", text)
    names = {first if re.match(r"\w", first) else second
             for first, second in found if also_optional or "REQUIRED" in first + second}
    return names | set(re.findall(r"find_path\(\w+ (\S+) REQUIRED\)", text))


def named(*kinds):
    package = xml.etree.ElementTree.parse(ROOT / "package.xml").getroot()
    return {element.text for kind in kinds for element in package.findall(kind)}


class PackageXml(unittest.TestCase):
    def test_what_is_built(self):
        expected = {name for file in BUILT for looked in looked_for(file, True) for name in NAMES[looked]}
        self.assertEqual(named(*KINDS), expected)

    def test_what_is_tested(self):
        """The tests look for some packages with QUIET; these are optional."""
        expected = {name for looked in looked_for("tests/CMakeLists.txt", False) for name in NAMES_OF_TESTS[looked]}
        self.assertEqual(named("test_depend"), expected)

    def test_tables_have_no_leftovers(self):
        self.assertEqual({looked for file in BUILT for looked in looked_for(file, True)}, set(NAMES))
        self.assertEqual(looked_for("tests/CMakeLists.txt", False), set(NAMES_OF_TESTS))

    def test_setup_installs_it(self):
        text = (ROOT / "scripts/setup").read_text()
        lists = [text.partition(f"{name}=(")[2].partition("\n)")[0] for name in ("tool_packages", "build_packages")]
        tools, others = [{word for line in part.splitlines() for word in line.partition("#")[0].split()} for part in lists]
        self.assertLessEqual(debian_packages(), tools | others)
        self.assertFalse(tools & others)
        for_tests = {DEBIAN.get(name, name) for name in named("test_depend")} - {"python3"}
        self.assertFalse(tools & for_tests, "the demo runs no tests")

    def test_debian_packages_are_built_with_it(self):
        text = (ROOT / "packaging/debian/control").read_text()
        fields = re.search(r"^Build-Depends: (.*?)\n(?=\S)", text, re.S | re.M)[1]
        needed = debian_packages() - {DEBIAN.get(name, name) for name in named("test_depend")}
        self.assertLessEqual(needed, {word.split()[0] for word in fields.split(",")} | {"python3"})

    def test_recipes_name_it(self):
        """The required packages, by the names of each system."""
        required = {name for file in BUILT for looked in looked_for(file, False) for name in NAMES[looked]}
        self.assertGreater(len(required), 7)
        for recipe in (ROOT / "packaging/recipes").iterdir():
            text = re.sub("[-_]", "", recipe.read_text())
            for name in required:
                word = re.sub("^lib|-dev$|[-_]", "", name)
                with self.subTest(recipe=recipe.name, name=name):
                    self.assertIn({"pkgconfig": "pkg"}.get(word, word), text)

    def test_version(self):
        version = re.search(r"\n  VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertEqual(named("version"), {version})


def debian_packages():
    return {DEBIAN.get(name, name) for name in named("buildtool_depend", *KINDS, "test_depend")}


if __name__ == "__main__":
    if sys.argv[1:] == ["--debian"]:
        print(*sorted(debian_packages()))
    else:
        unittest.main()
