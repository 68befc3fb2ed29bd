// SPDX-License-Identifier: BSD-3-Clause
// Texture coordinates of meshes, and whether a file has textures.
#include <doctest/doctest.h>

#include <algorithm>

#include "smurf/mesh_triangles.hpp"
#include "support/replaced.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

/// A square whose texture coordinates are its x and y, and an adjacent triangle with other texture
/// coordinates at the common side.
constexpr const char* kObj = "mtllib m.mtl\n"
                             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\n"
                             "vt 0 0\nvt 1 0\nvt 1 1 0\nvt 0 1\nvt 0.5\n"
                             "f 1/1 2/2 3/3 4/4\n"
                             "f 2/5/1 5/-5 -3/-1\n";

/// The shapes of kObj as COLLADA.
std::string collada() {
  return R"(<?xml version="1.0"?>
<COLLADA version="1.4.1">
  <library_effects><effect id="e"><profile_COMMON><technique sid="t"><phong>
    <diffuse><color>1 0 0 1</color></diffuse></phong></technique></profile_COMMON></effect>
  </library_effects>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="15">0 0 0 1 0 0 1 1 0 0 1 0 2 0 0</float_array></source>
    <source id="t"><float_array id="b" count="13">9 0 0 7 1 0 7 1 1 7 0 1 7</float_array>
      <technique_common><accessor source="#b" count="4" stride="3" offset="1">
        <param name="S"/><param name="T"/><param name="P"/></accessor></technique_common></source>
    <source id="u"><float_array id="c" count="4">0.5 0 0 0</float_array>
      <technique_common><accessor source="#c" count="2" stride="2"/></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <polylist count="1"><input semantic="TEXCOORD" source="#t" offset="1" set="0"/>
      <input semantic="VERTEX" source="#v" offset="0"/>
      <vcount>4</vcount><p>0 0 1 1 2 2 3 3</p></polylist>
    <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/>
      <input semantic="TEXCOORD" source="#u" offset="1"/>
      <p>1 0 4 1 2 0</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node>
  </visual_scene></library_visual_scenes>
</COLLADA>
)";
}

/// A triangle: three floats a point, then two bytes of texture coordinates and two of padding.
std::string gltf() {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
  "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
    {"bufferView": 1, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC2"}],
  "bufferViews": [{"buffer": 0, "byteLength": 36},
    {"buffer": 0, "byteOffset": 36, "byteLength": 12, "byteStride": 4}],
  "buffers": [{"byteLength": 48, "uri":
    "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAP8AAAAA/wAA"}]})";
}

MeshTriangles textured(const std::string& bytes, const MeshNeighbours& neighbours = {}) {
  const char* extension = bytes.starts_with('<')   ? ".dae"
                          : bytes.starts_with('{') ? ".gltf"
                                                   : ".obj";
  const MeshTriangles plain = read_triangles(bytes, extension, neighbours);
  MeshTriangles mesh = read_triangles(bytes, extension, neighbours, TexturePoints::read);
  CHECK(plain.texture_points.empty());
  CHECK(plain.reason == mesh.reason);
  CHECK(plain.has_textures == mesh.has_textures);
  REQUIRE(plain.indices.size() == mesh.indices.size());
  for (std::size_t i = 0; i < plain.indices.size(); ++i) {
    CHECK(plain.points[plain.indices[i]] == mesh.points[mesh.indices[i]]);
  }
  if (!mesh.texture_points.empty()) CHECK(mesh.texture_points.size() == mesh.points.size());
  return mesh;
}

/// The texture coordinates of the corners of all triangles.
std::vector<TexturePoint> corners(const MeshTriangles& mesh) {
  std::vector<TexturePoint> all;
  if (mesh.texture_points.empty()) return all;
  for (const std::uint32_t index : mesh.indices) all.push_back(mesh.texture_points[index]);
  return all;
}

/// Checks the texture coordinates of the two triangles of the square, whichever way it was cut, and
/// those of the third triangle.
void check_both(const MeshTriangles& mesh) {
  const std::vector<TexturePoint> found = corners(mesh);
  REQUIRE(found.size() == 9);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::array<float, 3>& point = mesh.points[mesh.indices[i]];
    CHECK(found[i] == TexturePoint{point[0], point[1]});
  }
  CHECK(found[6] == TexturePoint{0.5F, 0});
  CHECK(found[7] == TexturePoint{0, 0});
  CHECK(found[8] == TexturePoint{0.5F, 0});
  CHECK(mesh.points.size() == 7);
}

MeshNeighbours library(std::string text) {
  return [text = std::move(text)](const std::string& name) {
    return name == "m.mtl" ? FileContent{ReadStatus::ok, text, {}} : FileContent{};
  };
}

}  // namespace

TEST_CASE("texture coordinates: of OBJ") {
  check_both(textured(kObj));
  for (const char* corner :
       {"4/6", "4/0", "4/-6", "4", "4/", "4//1", "4/x", "4/99999999999999999999"}) {
    CAPTURE(corner);
    const MeshTriangles mesh = textured(replaced(kObj, "4/4", corner));
    CHECK(mesh.reason == "");
    CHECK(mesh.texture_points.empty());
  }
  for (const char* line : {"vt", "vt x 1", "vt 0 nan", "vt 0 1e300", "vt inf 1"}) {
    CAPTURE(line);
    const MeshTriangles mesh = textured(replaced(kObj, "vt 0 1\n", std::string(line) + "\n"));
    CHECK(mesh.reason == "");
    CHECK(mesh.texture_points.empty());
  }
}

TEST_CASE("texture coordinates: of COLLADA") {
  check_both(textured(collada()));
  const auto is_without = [](std::string_view from, std::string_view to) {
    const MeshTriangles mesh = textured(replaced(collada(), from, to));
    CHECK(mesh.reason == "");
    return mesh.texture_points.empty();
  };
  CHECK(is_without("0 0 1 1 2 2 3 3", "0 0 1 1 2 2 3 4"));
  CHECK(is_without("0 0 1 1 2 2 3 3", "0 0 1 1 2 2 3 -1"));
  CHECK(is_without("0 0 1 1 2 2 3 3", "0 0 1 1 2 2 3 x"));
  CHECK(is_without("source=\"#u\"", "source=\"#absent\""));
  CHECK(is_without("source=\"#u\"", "source=\"other.dae#u\""));
  CHECK(is_without(">0.5 0 0 0<", ">0.5 0 0 nan<"));
  CHECK(is_without("semantic=\"TEXCOORD\" source=\"#u\"", "semantic=\"NORMAL\" source=\"#u\""));
  CHECK(is_without("stride=\"3\"", "stride=\"9000000000\""));
  CHECK(is_without("offset=\"1\">\n", "offset=\"9000000000\">\n"));
}

TEST_CASE("texture coordinates: of glTF, whose rows count from above") {
  const MeshTriangles mesh = textured(gltf());
  const std::vector<TexturePoint> expected{{0, 1}, {1, 1}, {0, 0}};
  CHECK(corners(mesh) == expected);
  CHECK(corners(textured(replaced(gltf(), "5121, \"normalized\"", "5123, \"normalized\""))) ==
        std::vector<TexturePoint>{{0, 1},
                                  {static_cast<float>(255.0 / 65535), 1},
                                  {static_cast<float>(65280.0 / 65535), 1}});
  CHECK(textured(replaced(gltf(), ", \"TEXCOORD_0\": 1", "")).texture_points.empty());
  const auto reason = [](std::string_view from, std::string_view to) {
    const MeshTriangles broken =
        read_triangles(replaced(gltf(), from, to), ".gltf", {}, TexturePoints::read);
    CHECK(broken.points.empty());
    return broken.reason;
  };
  CHECK(reason("\"TEXCOORD_0\": 1", "\"TEXCOORD_0\": 2").starts_with("is broken"));
  CHECK(reason("\"TEXCOORD_0\": 1", "\"TEXCOORD_0\": 0").starts_with("is broken"));
  CHECK(reason("\"byteLength\": 12,", "\"byteLength\": 9,").starts_with("is broken"));
  CHECK(reason("5121, \"normalized\"", "5126, \"normalized\"").starts_with("is broken"));
}

TEST_CASE("texture coordinates: other formats have none") {
  const std::string stl =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid s\n";
  const MeshTriangles mesh = read_triangles(stl, ".stl", {}, TexturePoints::read);
  CHECK(mesh.reason == "");
  CHECK(mesh.indices.size() == 3);
  CHECK(mesh.texture_points.empty());
}

TEST_CASE("textures: whether a file has them") {
  CHECK(!textured(kObj).has_textures);
  CHECK(!textured(kObj, library("newmtl a\nKd 1 0 0\n")).has_textures);
  CHECK(textured(kObj, library("newmtl a\nmap_Kd a.png\n")).has_textures);
  CHECK(!textured(collada()).has_textures);
  CHECK(textured(replaced(collada(), "<color>1 0 0 1</color>", "<texture texture=\"s\"/>"))
            .has_textures);
  CHECK(!textured(gltf()).has_textures);
  CHECK(textured(replaced(gltf(), "\"baseColorFactor\": [1, 0, 0, 1]",
                          "\"baseColorTexture\": {\"index\": 0}"))
            .has_textures);
}
