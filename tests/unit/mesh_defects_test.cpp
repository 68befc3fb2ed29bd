// SPDX-License-Identifier: BSD-3-Clause
// Damaged mesh files that assimp refuses, found by changing single words of sound files.
#include <doctest/doctest.h>

#include "mesh/mesh_reader.hpp"
#include "support/replaced.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

constexpr const char* kStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid s\n";
constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/-1/-1\n";
constexpr const char* kDae = R"(<COLLADA version="1.4.1"><library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 2 0 0 2 2 0</float_array><technique_common>
<accessor source="#a" count="3" stride="3"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh>
</geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

std::string defect_of(std::string_view bytes, std::string_view extension) {
  const MeshFacts facts = read_mesh(bytes, extension);
  return facts.defect ? facts.defect->what : "";
}

}  // namespace

TEST_CASE("an ASCII STL begins with `solid`, and its normals are numbers") {
  CHECK(defect_of(kStl, ".stl") == "");
  CHECK(defect_of(std::string("  ") + kStl, ".stl") == "");
  for (const char* normal : {"nan nan nan", "-nan(ind) 0 0", "inf -inf .5", "1e3 +2 -.5"}) {
    CHECK(defect_of(replaced(kStl, "0 0 1\n", std::string(normal) + "\n"), ".stl") == "");
  }
  CHECK(defect_of(replaced(kStl, "0 0 1\n", "x 0 1\n"), ".stl") ==
        "`x` stands where a number is expected");
  for (const std::string start : {"\n", "\n\n  "}) {
    CHECK(defect_of(start + kStl, ".stl") ==
          "an ASCII STL has to begin with `solid`, in lower case");
  }
}

TEST_CASE("faces of an OBJ use texture coordinates and normals that exist") {
  CHECK(defect_of(kObj, ".obj") == "");
  CHECK(defect_of(replaced(kObj, "2/1/1", "2//1"), ".obj") == "");
  // Without any, assimp ignores the indices.
  CHECK(defect_of(replaced(kObj, "vn 0 0 1\n", ""), ".obj") == "");
  for (const char* corner : {"2/1/2", "2/1/x", "2/1/0", "2/1/-2"}) {
    CHECK(defect_of(replaced(kObj, "2/1/1", corner), ".obj") ==
          "a corner of a face uses a normal that the file does not have");
  }
  CHECK(defect_of(replaced(kObj, "2/1/1", "2/7/1"), ".obj") ==
        "a corner of a face uses texture coordinates that the file does not have");
}

TEST_CASE("references in COLLADA lead to elements") {
  CHECK(defect_of(kDae, ".dae") == "");
  CHECK(defect_of(replaced(kDae, "source=\"#a\"", "source=\"#b\""), ".dae") ==
        "the accessor of the points names no list of numbers of its source");
  CHECK(defect_of(replaced(kDae, "source=\"#v\"", "source=\"\""), ".dae") ==
        "the input VERTEX names no vertices of its mesh");
  CHECK(defect_of(replaced(kDae, "\"VERTEX\"", "\"NORMAL\""), ".dae") ==
        "no input of a primitive has the semantic VERTEX");
  CHECK(defect_of(replaced(kDae, "\"POSITION\"", "\"COLOR\""), ".dae") ==
        "the points of the mesh are missing");
  CHECK(defect_of(replaced(kDae, "0 1 2</p>", "0 1</p>"), ".dae") ==
        "the indices end inside a triangle");
  CHECK(defect_of(replaced(kDae, "0 1 2</p>", "0 1 3</p>"), ".dae") ==
        "the index `3` names none of 3 points");
  CHECK(defect_of(replaced(kDae, "url=\"#g\"", "url=\"#h\""), ".dae") ==
        "there is no element with the id `h`");
  CHECK(defect_of(replaced(kDae, "url=\"#s\"", "url=\"#t\""), ".dae") ==
        "there is no scene with the id `t`");
}
