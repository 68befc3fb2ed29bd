// SPDX-License-Identifier: BSD-3-Clause
// Colours that mesh files give: those of the material libraries of an OBJ, and the opacity of
// materials of COLLADA.
#include <doctest/doctest.h>

#include "mesh/mesh_reader.hpp"
#include "smurf/mesh_triangles.hpp"
#include "support/replaced.hpp"

using namespace smurf;

namespace {

constexpr const char* kObj =
    "mtllib colors.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "usemtl red\nf 1 2 3\nusemtl blue glass\nf 1 2 4\nusemtl red\nf 1 3 4\n";

using Colors = std::vector<std::optional<Rgba>>;

Colors colors_of(const MeshTriangles& mesh) {
  CHECK(mesh.reason.empty());
  Colors colors;
  for (const MeshPart& part : mesh.parts) colors.push_back(part.color);
  return colors;
}

Colors colors_with(const std::string& library, std::string_view obj = kObj) {
  const MeshNeighbours neighbours = [&](const std::string& name) {
    return name == "colors.mtl" ? FileContent{ReadStatus::ok, library, {}} : FileContent{};
  };
  return colors_of(read_triangles(obj, ".obj", neighbours));
}

std::string collada(const std::string& transparency) {
  return R"(<COLLADA version="1.4.1"><library_effects><effect id="e"><profile_COMMON><technique sid="t">
  <phong><diffuse><color>1 0.5 0.25 0.5</color></diffuse>)" +
         transparency + R"(</phong></technique></profile_COMMON></effect></library_effects>
  <library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="9">0 0 0 2 0 0 2 2 0</float_array></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles material="first" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material>
    <technique_common><instance_material symbol="first" target="#m"/></technique_common></bind_material>
  </instance_geometry></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

double opacity_with(const std::string& transparency) {
  const Colors colors = colors_of(read_triangles(collada(transparency), ".dae"));
  REQUIRE(colors.size() == 1);
  REQUIRE(colors[0]);
  return (*colors[0])[3];
}

std::string transparent(const std::string& mode, const std::string& color) {
  return "<transparent" + (mode.empty() ? "" : " opaque=\"" + mode + "\"") + "><color>" + color +
         "</color></transparent>";
}

std::string transparency(const std::string& value) {
  return "<transparency><float>" + value + "</float></transparency>";
}

}  // namespace

TEST_CASE("the materials of an OBJ have the colours of its libraries") {
  CHECK(colors_with("newmtl red\nKd 1 0 0\nnewmtl blue glass\nKd 0 0 1\nd 0.25\n") ==
        Colors{Rgba{1, 0, 0, 1}, Rgba{0, 0, 1, 0.25}});
  CHECK(
      colors_with("newmtl red\nTr 0.75\nKd 1 0 0\n\nnewmtl blue glass\nd -halo 0.5\nKd 0 0 1\n") ==
      Colors{Rgba{1, 0, 0, 0.25}, Rgba{0, 0, 1, 0.5}});
  // One number is a grey; values are shares.
  CHECK(colors_with("newmtl red\nKd 0.5\nnewmtl blue glass\nKd 2 -1 0\n") ==
        Colors{Rgba{0.5, 0.5, 0.5, 1}, Rgba{1, 0, 0, 1}});
  // Exporters that invert `Tr` would make everything invisible.
  CHECK(colors_with("newmtl red\nKd 1 0 0\nTr 1\nnewmtl blue glass\nKd 0 0 1\nTr 1\n") ==
        Colors{Rgba{1, 0, 0, 1}, Rgba{0, 0, 1, 1}});
}

TEST_CASE("an OBJ without usable colours has none") {
  CHECK(colors_with("newmtl other\nKd 1 0 0\n") == Colors{std::nullopt});
  CHECK(colors_with("newmtl red\nd 0.5\nnewmtl blue glass\nKd spectral a.rfl\n") ==
        Colors{std::nullopt});
  CHECK(colors_with("") == Colors{std::nullopt});
  CHECK(colors_of(read_triangles(kObj, ".obj")) == Colors{std::nullopt});
  // The first definition of a name applies; a library is read where it is named.
  CHECK(colors_with("newmtl red\nKd 1 0 0\nnewmtl red\nKd 0 1 0\n") ==
        Colors{std::nullopt, Rgba{1, 0, 0, 1}});
}

TEST_CASE("all triangles of an OBJ are in its parts") {
  const MeshNeighbours neighbours = [](const std::string&) {
    return FileContent{ReadStatus::ok, "newmtl red\nKd 1 0 0\n", {}};
  };
  const MeshTriangles mesh = read_triangles(kObj, ".obj", neighbours);
  REQUIRE(mesh.parts.size() == 2);
  CHECK(mesh.indices.size() == 9);
  CHECK(mesh.parts[1].first_index == 3);  // the triangle without a colour comes first
}

TEST_CASE("faces after the first group of an OBJ") {
  CHECK(!has_faces_after_first_group("o a\nv 0 0 0\nf 1 2 3\nf 2 3 4\n"));
  CHECK(!has_faces_after_first_group("v 0 0 0\no a\ng b\nf 1 2 3\n"));
  CHECK(!has_faces_after_first_group("f 1 2 3\no a\nv 0 0 0\n"));
  CHECK(has_faces_after_first_group("o a\nf 1 2 3\no b\nf 2 3 4\n"));
  CHECK(has_faces_after_first_group("f 1 2 3\ng b\nf 2 3 4\n"));
  CHECK(has_faces_after_first_group("o lines\nl 1 2\no b\nf 2 3 4\n"));
}

TEST_CASE("the opacity of a COLLADA material") {
  CHECK(opacity_with("") == 1);
  CHECK(opacity_with(transparency("0.25")) == 0.25);
  CHECK(opacity_with(transparent("", "0 0 0 0.5")) == 0.5);
  CHECK(opacity_with(transparent("A_ONE", "0 0 0 0.5") + transparency("0.5")) == 0.25);
  CHECK(opacity_with(transparent("RGB_ZERO", "0.25 0.25 0.25 1")) == 0.75);
  CHECK(opacity_with(transparent("RGB_ZERO", "0 0 0 1") + transparency("1")) == 1);
  CHECK(opacity_with(transparent("A_ZERO", "1 1 1 0.25")) == 0.75);
  CHECK(opacity_with(transparent("RGB_ONE", "0.5 0.5 0.5 1")) == 0.5);
  // What would be invisible is an exporter's mistake.
  CHECK(opacity_with(transparency("0")) == 1);
  CHECK(opacity_with(transparent("A_ONE", "1 1 1 1") + transparency("0")) == 1);
  CHECK(opacity_with(transparency("x")) == 1);
}
