// SPDX-License-Identifier: BSD-3-Clause
// Triangles of COLLADA and glTF: units, colours, and files that are broken or too much. That nodes
// and primitives are placed rightly is shown by tests/mesh/assimp_test.cpp.
#include "smurf/mesh_triangles.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <tuple>

#include "mesh/mesh_reader.hpp"
#include "mesh/random_gltf.hpp"
#include "mesh/shape.hpp"
#include "support/replaced.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

/// A triangle and a square, 2 units large, with a material each.
std::string collada() {
  return R"(<?xml version="1.0"?>
<COLLADA version="1.4.1">
  <asset><unit meter="0.01"/><up_axis>Y_UP</up_axis></asset>
  <library_effects>
    <effect id="redEffect"><profile_COMMON><technique sid="t"><phong>
      <diffuse><color>1 0.5 0.25 0.5</color></diffuse></phong></technique></profile_COMMON></effect>
    <effect id="wood"><profile_COMMON><technique sid="t"><lambert>
      <diffuse><texture texture="w" texcoord="c"/></diffuse></lambert></technique></profile_COMMON>
    </effect>
  </library_effects>
  <library_materials>
    <material id="red"><instance_effect url="#redEffect"/></material>
    <material id="grained"><instance_effect url="#wood"/></material>
  </library_materials>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="12">0 0 0 2 0 0 2 2 0 0 2 0</float_array></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles material="first" count="1"><input semantic="VERTEX" source="#v" offset="0"/>
      <p>0 1 2</p></triangles>
    <polylist material="second" count="1"><input semantic="VERTEX" source="#v" offset="0"/>
      <vcount>4</vcount><p>0 1 2 3</p></polylist>
  </mesh></geometry></library_geometries>
  <library_nodes><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
    <instance_material symbol="first" target="#red"/>
    <instance_material symbol="second" target="#grained"/>
  </technique_common></bind_material></instance_geometry></node></library_nodes>
  <library_visual_scenes><visual_scene id="s"><node id="top">
    <translate>0 0 100</translate><instance_node url="#n"/>
  </node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";
}

/// A triangle 1 m above the origin: y is up.
std::string gltf() {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0, "translation": [0, 1, 0]}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
  "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.214041, 0, 0.5]},
    "alphaMode": "BLEND"}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
    {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 3}],
  "buffers": [{"byteLength": 39, "uri":
    "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAEC"}]})";
}

std::string reason(const std::string& bytes, const MeshNeighbours& neighbours = {}) {
  const MeshTriangles mesh =
      read_triangles(bytes, bytes.starts_with('<') ? ".dae" : ".gltf", neighbours);
  CHECK(mesh.points.empty() == !mesh.reason.empty());
  CHECK(mesh.indices.empty() == !mesh.reason.empty());
  return mesh.reason;
}

}  // namespace

TEST_CASE("triangles: COLLADA in metres, in its own axes, with its colours") {
  const MeshTriangles mesh = read_triangles(collada(), ".dae");
  CHECK(mesh.reason == "");
  REQUIRE(mesh.indices.size() == 9);
  // Triangles without colour come first.
  REQUIRE(mesh.parts.size() == 2);
  CHECK(!mesh.parts[0].color);
  CHECK(mesh.parts[0].first_index == 0);
  CHECK(mesh.parts[0].first_point == 0);
  CHECK(mesh.parts[1].color == Rgba{1, 0.5, 0.25, 1});
  CHECK(mesh.parts[1].first_index == 6);
  CHECK(mesh.parts[1].first_point == 4);
  REQUIRE(mesh.points.size() == 7);
  CHECK(mesh.points[2] == std::array<float, 3>{0.02F, 0.02F, 1});
  for (std::size_t i = 0; i < 3; ++i) CHECK(mesh.indices[6 + i] == 4 + i);
}

TEST_CASE("triangles: a concave polygon is cut along its inside") {
  // An arrow; a fan around its first corner would cover parts outside of it.
  const std::string arrow =
      replaced(collada(), "0 0 0 2 0 0 2 2 0 0 2 0", "0 0 0 4 -2 0 1 0 0 4 2 0");
  const MeshTriangles mesh = read_triangles(replaced(arrow, "<p>0 1 2 3<", "<p>1 2 3 0<"), ".dae");
  REQUIRE(mesh.indices.size() == 9);
  ShapeSums sums;
  for (std::size_t i = 0; i < 6; i += 3) {
    Vector3 corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) corners[k][c] = mesh.points[mesh.indices[i + k]][c];
    }
    sums.add(corners[0], corners[1], corners[2]);
  }
  CHECK(sums.area == doctest::Approx(2e-4));
  CHECK(sums.area == doctest::Approx(std::fabs(sums.area_vector[2])));
}

TEST_CASE("triangles: COLLADA with `<` in attributes, which readers of meshes read") {
  const std::string first = replaced(collada(), "id=\"p\"", "id=\"<p>\"");
  const MeshTriangles mesh = read_triangles(replaced(first, "\"#p\"", "\"#<p>\""), ".dae");
  CHECK(mesh.reason == "");
  CHECK(mesh.indices.size() == 9);
}

TEST_CASE("triangles: COLLADA that is broken") {
  const auto broken = [](std::string_view from, std::string_view to) {
    return reason(replaced(collada(), from, to));
  };
  CHECK(broken("<p>0 1 2 3<", "<p>0 1 2 4<") ==
        "is broken: the index `4` names none of 4 points (line 21)");
  CHECK(broken("<p>0 1 2 3<", "<p>0 1 2 -1<").find("the index `-1`") != std::string::npos);
  CHECK(broken("<p>0 1 2 3<", "<p>0 1 2 99999999999999999999<").starts_with("is broken: "));
  CHECK(broken("<vcount>4<", "<vcount>5<").find("more corners") != std::string::npos);
  CHECK(broken("<vcount>4<", "<vcount>3<").find("more indices") != std::string::npos);
  CHECK(broken("<vcount>4<", "<vcount>18446744073709551615<").starts_with("is broken: "));
  CHECK(broken("<p>0 1 2<", "<p>0 1<") == "is broken: the indices end inside a triangle (line 19)");
  CHECK(broken("offset=\"0\"/>\n      <p>", "offset=\"4000000000\"/>\n      <p>")
            .starts_with("is broken: "));
  CHECK(broken(">0 0 0 2", ">0 0 0 nan").find("not numbers") != std::string::npos);
  CHECK(broken("source=\"#p\"", "source=\"#q\"").find("the points of the mesh are missing") !=
        std::string::npos);
  CHECK(broken("url=\"#g\"", "url=\"#h\"") ==
        "is broken: there is no element with the id `h` (line 23)");
  CHECK(broken("0 0 100", "0 0") ==
        "is broken: the transform of a node is not a list of numbers (line 28)");
  CHECK(broken("</mesh>", "").starts_with("is broken: "));
  CHECK(broken("0 0 100", "0 0 1e300") == "has a coordinate that is too large");
  // The entities of a document type are not expanded.
  const std::string bomb = R"(<!DOCTYPE c [<!ENTITY a "0 0 "><!ENTITY b "&a;&a;&a;&a;&a;&a;">]>)";
  const std::string file = replaced(collada(), "<COLLADA", bomb + "\n<COLLADA");
  CHECK(reason(replaced(file, "<p>0 1 2<", "<p>&b;<")) ==
        "is broken: the index `&b;` names none of 4 points (line 20)");
}

TEST_CASE("triangles: COLLADA with rings, and with more than is read") {
  const auto changed = [](std::string_view from, std::string_view to) {
    return reason(replaced(collada(), from, to));
  };
  CHECK(changed("<instance_geometry url=\"#g\">",
                "<instance_node url=\"#top\"/><instance_geometry url=\"#g\">")
            .starts_with("is broken: a node contains itself"));
  // Each node names the next one twice.
  std::string doubled;
  for (int i = 0; i < 60; ++i) {
    const std::string next = "<instance_node url=\"#x" + std::to_string(i + 1) + "\"/>";
    doubled += "<node id=\"x" + std::to_string(i) + "\">" + next + next + "</node>";
  }
  doubled += "<node id=\"x60\"/><node id=\"n\">";
  const std::string start = replaced(collada(), "url=\"#n\"", "url=\"#x0\"");
  CHECK(reason(replaced(start, "<node id=\"n\">", doubled)) == "repeats too many nodes to be read");
  // The same with triangles at the end.
  CHECK(reason(replaced(replaced(start, "<node id=\"n\">", doubled), "<node id=\"x60\"/>",
                        "<node id=\"x60\"><instance_geometry url=\"#g\"/></node>")) ==
        "has more than 3000000 triangles");
  std::string chain;
  for (int i = 0; i < 1000; ++i) {
    chain += "<node id=\"x" + std::to_string(i) + "\"><instance_node url=\"#x" +
             std::to_string(i + 1) + "\"/></node>";
  }
  CHECK(reason(replaced(start, "<node id=\"n\">", chain + "<node id=\"n\">")) ==
        "nests nodes too deeply to be read");
  CHECK(changed("<instance_node url=\"#n\"/>", "<instance_controller url=\"#c\"/>") ==
        "has skins (instance_controller), which are not read");
  CHECK(changed("<translate>0 0 100</translate>", "<lookat>0 0 0 1 0 0 0 0 1</lookat>") ==
        "is placed by <lookat>, which is not read");
  CHECK(changed("url=\"#n\"", "url=\"other.dae#n\"") ==
        "names parts of other files, which are not read");
  CHECK(changed("<scene><instance_visual_scene url=\"#s\"/></scene>",
                "<library_visual_scenes><visual_scene id=\"t\"/></library_visual_scenes>") ==
        "has no scene that places its parts");
  CHECK(changed("<instance_node url=\"#n\"/>", "") == "has no triangles");
}

TEST_CASE("triangles: a list of corners that crosses itself costs little") {
  std::string corners;
  std::string points;
  for (int i = 0; i < 20000; ++i) {
    corners += std::to_string(i) + " ";
    points += std::to_string(i * 7919 % 101) + " " + std::to_string(i * 104729 % 97) + " 0 ";
  }
  std::string polygons;
  for (int i = 0; i < 80; ++i) polygons += "250 ";
  std::string file = replaced(collada(), "0 0 0 2 0 0 2 2 0 0 2 0", points);
  file = replaced(file, "<vcount>4</vcount><p>0 1 2 3<",
                  "<vcount>" + polygons + "</vcount><p>" + corners + "<");
  const MeshTriangles mesh = read_triangles(file, ".dae");
  CHECK(mesh.reason == "");
  CHECK(mesh.indices.size() == 3 * (1 + 80 * 248));
}

TEST_CASE("triangles: glTF with z up, with its colours") {
  const MeshTriangles mesh = read_triangles(gltf(), ".gltf");
  CHECK(mesh.reason == "");
  REQUIRE(mesh.points.size() == 3);
  CHECK(mesh.points[0] == std::array<float, 3>{0, 0, 1});
  CHECK(mesh.points[1] == std::array<float, 3>{1, 0, 1});
  CHECK(mesh.points[2] == std::array<float, 3>{0, 0, 2});
  REQUIRE(mesh.parts.size() == 1);
  REQUIRE(mesh.parts[0].color);
  const Rgba expected{1, 0.5, 0, 0.5};  // of a screen
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK((*mesh.parts[0].color)[i] == doctest::Approx(expected[i]).epsilon(1e-4));
  }
}

TEST_CASE("triangles: glTF that is broken") {
  const auto broken = [](std::string_view from, std::string_view to) {
    return reason(replaced(gltf(), from, to));
  };
  const auto contains = [](const std::string& text, std::string_view part) {
    CAPTURE(text);
    CHECK(text.find(part) != std::string::npos);
  };
  contains(broken("AAEC\"", "AAED\""), "the index 3 names none of 3 points");
  contains(broken("base64,AAAA", "base64,A*AA"), "not base64");
  contains(broken("base64,AAAA", "base64,AAA"), "accessor");
  contains(broken("data:;base64,", "data:,"), "not base64");
  contains(broken("\"byteLength\": 36}", "\"byteLength\": 35}"), "beyond the end");
  contains(broken("\"byteLength\": 36}", "\"byteLength\": 99}"), "beyond the end");
  contains(broken("\"count\": 3, \"type\": \"VEC3\"", "\"count\": 4000000000, \"type\": \"VEC3\""),
           "beyond the end");
  contains(broken("\"count\": 3, \"type\": \"VEC3\"",
                  "\"count\": 18446744073709551615, \"type\": \"VEC3\""),
           "invalid");
  contains(broken("\"count\": 3, \"type\": \"VEC3\"", "\"count\": -1, \"type\": \"VEC3\""),
           "invalid");
  contains(broken("\"byteOffset\": 36", "\"byteOffset\": 1099511627776"), "beyond the end");
  contains(broken("\"buffer\": 0, \"byteLength\": 36",
                  "\"buffer\": 0, \"byteStride\": 1099511627776, \"byteLength\": 36"),
           "beyond the end");
  contains(broken("\"buffer\": 0, \"byteLength\": 36",
                  "\"buffer\": 0, \"byteStride\": 0, \"byteLength\": 36"),
           "invalid");
  contains(broken("\"componentType\": 5126", "\"componentType\": 5123"), "not floats");
  contains(broken("\"POSITION\": 0", "\"POSITION\": 7"), "its accessors that does not exist");
  contains(broken("\"POSITION\": 0", "\"POSITION\": \"0\""), "its accessors that does not exist");
  contains(broken("\"mesh\": 0", "\"mesh\": 0, \"children\": [0]"), "a node is named twice");
  contains(broken("\"nodes\": [0]}", "\"nodes\": [0, 0]}"), "a node is named twice");
  contains(broken("[0, 1, 0]", "[0, 1]"), "the transform of a node is invalid");
  contains(broken("[0, 1, 0]", "[0, 1e400, 0]"), "not JSON");
  contains(broken("\"translation\": [0, 1, 0]", "\"rotation\": [0, 0, 0, 0]"),
           "the transform of a node is invalid");
  contains(broken("AACAPwAA", "AACAfwAA"), "not numbers");
  contains(broken("\"material\": 0", "\"material\": 1"), "its materials that does not exist");
  contains(broken("\"indices\": 1", "\"indices\": 1, \"mode\": 7"), "unknown mode");
  CHECK(broken("\"indices\": 1", "\"indices\": 1, \"mode\": 1") == "has no triangles");
  contains(broken("[0, 1, 0]}],", "[0, 1, 0]}],,"), "not JSON");
  contains(broken("\"nodes\": [{", "\"nodes\": 3, \"x\": [{"), "its nodes that does not exist");
}

TEST_CASE("triangles: glTF with more than is read") {
  const auto changed = [](std::string_view from, std::string_view to) {
    return reason(replaced(gltf(), from, to));
  };
  CHECK(changed("\"scene\": 0", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"]") ==
        "needs KHR_draco_mesh_compression of glTF, which is not read");
  CHECK(changed("\"scene\": 0", "\"extensionsRequired\": [\"KHR_materials_unlit\"]") == "");
  CHECK(changed("\"version\": \"2.0\"", "\"version\": \"1.0\"") ==
        "is glTF 1.0, which is not read");
  CHECK(changed("\"mesh\": 0", "\"mesh\": 0, \"skin\": 0") == "has skins, which are not read");
  CHECK(changed("\"count\": 3, \"type\": \"VEC3\"",
                "\"count\": 3, \"type\": \"VEC3\", \"sparse\": {}") ==
        "has sparse accessors, which are not read");
  CHECK(reason("{\"asset\": " + std::string(100000, '[')) == "has too much JSON to be read");
  CHECK(reason("{\"asset\": [1" + std::string(2000000, ',') + "]}") ==
        "has too much JSON to be read");
  // A mesh that thousands of nodes name, and the mesh names its triangles thousands of times.
  std::string nodes;
  std::string roots;
  std::string primitives;
  for (int i = 0; i < 4000; ++i) {
    nodes += (i > 0 ? ", " : "") + std::string("{\"mesh\": 0}");
    roots += (i > 0 ? ", " : "") + std::to_string(i);
    primitives += (i > 0 ? ", " : "") + std::string("{\"attributes\": {\"POSITION\": 0}}");
  }
  std::string file = replaced(gltf(), "{\"mesh\": 0, \"translation\": [0, 1, 0]}", nodes);
  file = replaced(file, "\"nodes\": [0]", "\"nodes\": [" + roots + "]");
  const std::string primitive =
      "{\"attributes\": {\"POSITION\": 0}, \"indices\": 1, \"material\": 0}";
  CHECK(reason(file) == "");
  CHECK(reason(replaced(file, primitive, primitives)) == "has more than 3000000 triangles");
  std::string lines = primitives;
  for (std::size_t at = lines.find("0}}"); at != std::string::npos; at = lines.find("0}}", at)) {
    lines.replace(at, 3, "0}, \"mode\": 1}");
  }
  CHECK(reason(replaced(file, primitive, lines)) == "repeats too many parts to be read");
}

TEST_CASE("triangles: buffers of glTF beside the file") {
  const auto named = [](std::string_view name) {
    const std::string file = gltf();
    const std::size_t begin = file.find("data:");
    return file.substr(0, begin) + std::string(name) + file.substr(file.find('"', begin));
  };
  MemoryFiles files;
  const std::string text = named("my%20points.bin");
  files.add("/robot/meshes/m.gltf", text);
  CHECK(read_triangles_of("/robot/meshes/m.gltf", files, {}).reason ==
        "has its points in `my points.bin`, which does not exist");
  std::string points(39, '\0');
  points[14] = '\x80';
  points[15] = '\x3f';
  points[30] = '\x80';
  points[31] = '\x3f';
  points[37] = '\1';
  points[38] = '\2';
  files.add("/robot/meshes/my points.bin", points);
  CHECK(read_triangles_of("/robot/meshes/m.gltf", files, {}).reason == "");
  files.add("/robot/data.bin", points);
  files.add("/robot/meshes/up.gltf", named("../data.bin"));
  CHECK(read_triangles_of("/robot/meshes/up.gltf", files, {}).reason == "");
  Limits small;
  small.mesh_bytes = 10'000;
  files.add("/robot/large.bin", points + std::string(20'000, '\0'));
  files.add("/robot/meshes/large.gltf", named("../large.bin"));
  CHECK(read_triangles_of("/robot/meshes/large.gltf", files, {}).reason == "");
  CHECK(read_triangles_of("/robot/meshes/large.gltf", files, small)
            .reason.starts_with("has its points in `../large.bin`, which cannot be read: "));
  CHECK(reason(text) == "has its points in `my points.bin`, which does not exist");
  for (const char* name : {"/robot/data.bin", "file:///robot/data.bin", "http://robot/data.bin"}) {
    files.add("/robot/meshes/else.gltf", named(name));
    CHECK(read_triangles_of("/robot/meshes/else.gltf", files, {}).reason ==
          "has its points in `" + std::string(name) + "`, which is not a file beside it");
  }
}

TEST_CASE("mesh: facts about glTF") {
  const MeshFacts facts = read_mesh(gltf(), ".gltf");
  CHECK(facts.format == MeshFormat::gltf);
  CHECK(facts.triangles == 1);
  CHECK(facts.vertices == 3);
  CHECK(!facts.defect);
  CHECK(facts.unread == "");
  REQUIRE(facts.box);
  CHECK(facts.box->low == Vector3{0, 0, 1});
  CHECK(facts.box->high == Vector3{1, 0, 2});
  const MeshFacts skinned =
      read_mesh(replaced(gltf(), "\"mesh\": 0", "\"mesh\": 0, \"skin\": 0"), ".gltf");
  CHECK(skinned.unread == "has skins, which are not read");
  CHECK(!skinned.defect);
  CHECK(!skinned.box);
  const MeshFacts broken = read_mesh(replaced(gltf(), "AAEC\"", "AAED\""), ".gltf");
  REQUIRE(broken.defect);
  CHECK(broken.defect->what == "the index 3 names none of 3 points");
  CHECK(!broken.box);
}

TEST_CASE("mesh: facts about glTF equal its triangles") {
  Random random;
  for (int i = 0; i < 200; ++i) {
    const GltfFile file = random_gltf(random);
    const std::string extension = file.name.substr(file.name.rfind('.'));
    const auto neighbours = [&](const std::string& name) {
      const auto found = file.beside.find(name);
      return found == file.beside.end() ? FileContent{}
                                        : FileContent{ReadStatus::ok, found->second, {}};
    };
    CAPTURE(seed());
    CAPTURE(file.bytes);
    const MeshTriangles mesh = read_triangles(file.bytes, extension, neighbours);
    const MeshFacts facts = read_mesh(file.bytes, extension, {}, neighbours);
    CHECK(!facts.defect);
    CHECK(facts.unread == "");
    CHECK(3 * facts.triangles == mesh.indices.size());
    REQUIRE(facts.box);
    const Vector3 size = facts.box->size();
    const double margin = 1e-5 * (1 + size[0] + size[1] + size[2]);
    for (const auto& point : mesh.points) {
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(point[k] >= facts.box->low[k] - margin);
        CHECK(point[k] <= facts.box->high[k] + margin);
      }
    }
  }
}

TEST_CASE("mesh: glTF whose nodes and accessors repeat a mesh costs little") {
  std::string accessors;
  std::string primitives;
  for (int i = 0; i < 20'000; ++i) {
    accessors += R"({"bufferView": 0, "componentType": 5126, "count": 3000, "type": "VEC3"}, )";
    primitives += (i > 0 ? ", " : "") + std::string("{\"attributes\": {\"POSITION\": ") +
                  std::to_string(i) + "}}";
  }
  std::string file = replaced(gltf(), "\"accessors\": [", "\"accessors\": [" + accessors);
  file = replaced(file, "{\"attributes\": {\"POSITION\": 0}, \"indices\": 1, \"material\": 0}",
                  primitives);
  file = replaced(file, "\"byteLength\": 36}", "\"byteLength\": 36000}");
  const std::size_t begin = file.find("data:");
  file.replace(begin, file.find('"', begin) - begin, "points.bin");
  std::size_t reads = 0;
  const MeshFacts facts = read_mesh(file, ".gltf", {}, [&](const std::string&) {
    ++reads;
    return FileContent{ReadStatus::ok, std::string(36'003, '\0'), {}};
  });
  CHECK(reads == 1);
  CHECK(facts.unread == "repeats too many parts to be read");
}

TEST_CASE("mesh: the files that a glTF names, and where") {
  const auto neighbours = [](const std::string& name) {
    return FileContent{ReadStatus::ok, std::string(name == "a b\".bin" ? 30 : 39, '\0'), {}};
  };
  std::string file = gltf();
  const std::size_t begin = file.find("data:");
  file.replace(begin, file.find('"', begin) - begin, R"(a%20b\".bin)");
  file = replaced(file, "\"scene\": 0,",
                  "\n\"images\": [{\"uri\": \"x\\\\\"}, {\"name\": \"uri\", \"uri\": \"data:,\"}],"
                  " \"extras\": {\"images\": [{\"uri\": \"no\"}]},");
  const MeshFacts facts = read_mesh(file, ".gltf", {}, neighbours);
  REQUIRE(facts.dependencies.size() == 2);
  const auto& [image, buffer] = std::tie(facts.dependencies[0], facts.dependencies[1]);
  CHECK(image.filename == "x\\");
  CHECK(image.kind == MeshDependency::Kind::texture);
  CHECK(image.line == 2);
  CHECK(file.substr(image.offset, image.length) == "x\\\\");
  CHECK(buffer.path() == "a b\".bin");
  CHECK(buffer.kind == MeshDependency::Kind::buffer);
  CHECK(buffer.line == 11);
  CHECK(file.substr(buffer.offset, buffer.length) == R"(a%20b\".bin)");
  REQUIRE(facts.defect);
  CHECK(facts.defect->line == 11);
  CHECK(facts.defect->what == "the buffer `a b\".bin` has 30 of 39 bytes");

  const FileNames names{{image.filename, "t/x.png"}, {buffer.filename, "2/b.bin"}};
  const std::string other = with_other_names(file, ".gltf", names);
  CHECK(other == replaced(replaced(file, R"(a%20b\".bin)", "2/b.bin"), "x\\\\", "t/x.png"));
  const std::string binary = gltf_binary(file, "");
  const std::string renamed = with_other_names(binary, ".glb", names);
  CHECK(renamed.size() % 4 == 0);
  const std::vector<MeshDependency> named = files_named_in(renamed, ".glb");
  REQUIRE(named.size() == 2);
  CHECK(named[0].filename == "t/x.png");
  CHECK(named[0].line == 0);
  CHECK(named[1].filename == "2/b.bin");
  const MeshFacts read = read_mesh(renamed, ".glb", {}, neighbours);
  CHECK(!read.defect);
  CHECK(read.triangles == 1);
}

TEST_CASE("mesh: other names in OBJ, material libraries and COLLADA") {
  const auto check = [](std::string_view text, std::string_view extension, const FileNames& names,
                        std::string_view expected) {
    CHECK(with_other_names(text, extension, names) == expected);
  };
  check("mtllib my colours.mtl\nv 0 0 0\nmtllib b.mtl\r\n", ".obj",
        {{"my colours.mtl", "2/c.mtl"}, {"b.mtl", "longer.mtl"}},
        "mtllib 2/c.mtl\nv 0 0 0\nmtllib longer.mtl\r\n");
  check("newmtl a\nmap_Kd wood grain.png\nmap_Ks -o 1 a.png\n", ".mtl",
        {{"wood grain.png", "w.png"}}, "newmtl a\nmap_Kd w.png\nmap_Ks -o 1 a.png\n");
  check("mtllib a\\\n.mtl\nv 0 0 0\n", ".obj", {{"a .mtl", "b.mtl"}},
        "mtllib a\\\n.mtl\nv 0 0 0\n");
  check("<COLLADA><library_images><image><init_from> a&amp;b.png\n</init_from></image>"
        "</library_images></COLLADA>",
        ".dae", {{"a&b.png", "a_b.png"}},
        "<COLLADA><library_images><image><init_from> a_b.png\n</init_from></image>"
        "</library_images></COLLADA>");
}

TEST_CASE("triangles: binary glTF that is broken") {
  const std::string file = gltf_binary(gltf(), "");
  CHECK(read_triangles(file, ".glb").reason == "");
  for (std::size_t size = 4; size < file.size(); ++size) {
    CHECK(read_triangles(file.substr(0, size), ".glb").reason != "");
  }
  std::string old = file;
  old[4] = '\1';
  CHECK(read_triangles(old, ".glb").reason == "is glTF 1, which is not read");
  std::string huge = file;
  for (std::size_t i = 12; i < 16; ++i) huge[i] = '\xff';
  CHECK(read_triangles(huge, ".glb").reason == "is broken: a chunk is longer than the file");
}
