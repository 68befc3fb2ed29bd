// SPDX-License-Identifier: BSD-3-Clause
// Meshes that the test writes: their facts, and broken files, which do no harm.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <tuple>

#include "mesh/mesh_reader.hpp"
#include "smurf/mesh_triangles.hpp"
#include "support/replaced.hpp"
#include "unit/random.hpp"

using namespace smurf;
using smurf::test::replaced;

namespace {

/// A corner of a box from (0, 0, 0) to (1, 2, 3).
struct Corner {
  int x, y, z;
};

Vector3 place(const Corner& corner) { return {1.0 * corner.x, 2.0 * corner.y, 3.0 * corner.z}; }

/// Twelve triangles that face outward.
const std::vector<std::array<Corner, 3>>& box_triangles() {
  static const std::vector<std::array<Corner, 3>> triangles = [] {
    const std::array<Corner, 4> sides[] = {
        {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},  // bottom
        {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},  // top
        {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}},  // front
        {{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}},  // back
        {{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}},  // left
        {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}},  // right
    };
    std::vector<std::array<Corner, 3>> all;
    for (const auto& side : sides) {
      all.push_back({side[0], side[1], side[2]});
      all.push_back({side[0], side[2], side[3]});
    }
    return all;
  }();
  return triangles;
}

void put(std::string& bytes, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}
void put(std::string& bytes, double value) {
  put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

std::string binary_stl(const std::string& header = "a box") {
  std::string bytes = header + std::string(80 - header.size(), '\0');
  put(bytes, static_cast<std::uint32_t>(box_triangles().size()));
  for (const auto& triangle : box_triangles()) {
    for (int i = 0; i < 3; ++i) put(bytes, 0.0);  // normal
    for (const Corner& corner : triangle) {
      for (const double coordinate : place(corner)) put(bytes, coordinate);
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string numbers(const Vector3& point) {
  std::string text;
  for (const double coordinate : point) text += " " + std::to_string(coordinate);
  return text;
}

std::string ascii_stl() {
  std::string text = "solid a box\n";
  for (const auto& triangle : box_triangles()) {
    text += "facet normal 0 0 0\n  outer loop\n";
    for (const Corner& corner : triangle) text += "    vertex" + numbers(place(corner)) + "\n";
    text += "  endloop\nendfacet\n";
  }
  return text + "endsolid a box\n";
}

int index(const Corner& corner) { return 1 + corner.x + 2 * corner.y + 4 * corner.z; }

std::string obj() {
  std::string text = "# a box\nmtllib box.mtl\no box\n";
  for (int i = 0; i < 8; ++i) text += "v" + numbers(place({i & 1, i >> 1 & 1, i >> 2})) + "\n";
  text += "vn 0 0 1\n";
  for (const auto& triangle : box_triangles()) {
    text += "f";
    for (const Corner& corner : triangle) text += " " + std::to_string(index(corner)) + "//1";
    text += "\n";
  }
  return text;
}

std::string bobj() {
  std::string bytes;
  for (int i = 0; i < 8; ++i) {
    put(bytes, 1U);
    for (const double coordinate : place({i & 1, i >> 1 & 1, i >> 2})) put(bytes, coordinate);
  }
  put(bytes, 3U);
  for (const double coordinate : {0.0, 0.0, 1.0}) put(bytes, coordinate);
  for (const auto& triangle : box_triangles()) {
    put(bytes, 4U);
    for (const Corner& corner : triangle) {
      put(bytes, static_cast<std::uint32_t>(index(corner)));
      put(bytes, 0U);
      put(bytes, 1U);
    }
  }
  return bytes;
}

/// The box turned by a node so that its x axis is the scene's y axis, and moved along x.
std::string collada() {
  std::string positions;
  for (int i = 0; i < 8; ++i) positions += numbers(place({i & 1, i >> 1 & 1, i >> 2}));
  return R"(<?xml version="1.0"?>
<COLLADA version="1.4.1">
  <asset><unit name="inch" meter="0.0254"/><up_axis>Z_UP</up_axis></asset>
  <library_images><image id="i"><init_from>wood.png</init_from></image></library_images>
  <library_lights><light id="sun"/></library_lights>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="24">)" +
         positions + R"(</float_array></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <polylist count="6"><vcount>4 4 4 4 4 4</vcount></polylist>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node>
    <translate>10 0 0</translate><rotate>0 0 1 90</rotate><instance_geometry url="#g"/>
  </node></visual_scene></library_visual_scenes>
</COLLADA>
)";
}

const Box kBox{{0, 0, 0}, {1, 2, 3}};

void check_box(const MeshFacts& facts, MeshFormat format, std::uint64_t vertices) {
  CAPTURE(to_string(format));
  CHECK(facts.format == format);
  CHECK(facts.triangles == 12);
  CHECK(facts.vertices == vertices);
  CHECK(!facts.defect);
  REQUIRE(facts.box);
  CHECK(*facts.box == kBox);
  REQUIRE(facts.solid);
  CHECK(facts.solid->volume == doctest::Approx(6).epsilon(1e-6));
}

std::string defect(const std::string& bytes, std::string_view extension = "") {
  const MeshFacts facts = read_mesh(bytes, extension);
  if (!facts.defect) return "none";
  return std::to_string(facts.defect->line) + ": " + facts.defect->what;
}

}  // namespace

TEST_CASE("mesh: one box in five formats") {
  check_box(read_mesh(binary_stl(), ".stl"), MeshFormat::stl_binary, 36);
  check_box(read_mesh(ascii_stl(), ".STL"), MeshFormat::stl_ascii, 36);
  check_box(read_mesh(obj(), ".obj"), MeshFormat::obj, 8);
  check_box(read_mesh(bobj(), ".bobj"), MeshFormat::bobj, 8);

  const MeshFacts facts = read_mesh(collada(), ".dae");
  CHECK(facts.format == MeshFormat::collada);
  CHECK(facts.triangles == 12);
  CHECK(facts.unit_meters == 0.0254);
  CHECK(facts.up_axis == 'Z');
  CHECK(facts.extras == std::vector<std::string>{"lights"});
  REQUIRE(facts.dependencies.size() == 1);
  CHECK(facts.dependencies[0].filename == "wood.png");
  CHECK(facts.dependencies[0].line == 4);
  REQUIRE(facts.box);
  const Vector3 low{8, 0, 0};
  const Vector3 high{10, 1, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(facts.box->low[i] == doctest::Approx(low[i]));
    CHECK(facts.box->high[i] == doctest::Approx(high[i]));
  }
}

TEST_CASE("mesh: triangles, on demand") {
  for (const auto& [bytes, extension] :
       {std::pair(binary_stl(), ".stl"), std::pair(ascii_stl(), ".stl"), std::pair(obj(), ".obj"),
        std::pair(bobj(), ".bobj")}) {
    const MeshTriangles mesh = read_triangles(bytes, extension);
    CHECK(mesh.reason.empty());
    CHECK(mesh.points.size() == 8);
    REQUIRE(mesh.indices.size() == 36);
    const MeshFacts facts = read_mesh(bytes, extension);
    Box box{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
    double volume = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const auto& [a, b, c] =
          std::tie(mesh.points[mesh.indices[i]], mesh.points[mesh.indices[i + 1]],
                   mesh.points[mesh.indices[i + 2]]);
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                 a[2] * (b[0] * c[1] - b[1] * c[0])) /
                6;
      for (const auto& point : {a, b, c}) {
        for (std::size_t k = 0; k < 3; ++k) {
          box.low[k] = std::min(box.low[k], double{point[k]});
          box.high[k] = std::max(box.high[k], double{point[k]});
        }
      }
    }
    CHECK(box == *facts.box);
    CHECK(volume == doctest::Approx(facts.solid->volume));
  }
  const auto reason = [](const std::string& bytes, std::string_view extension) {
    const MeshTriangles mesh = read_triangles(bytes, extension);
    CHECK(mesh.points.empty());
    CHECK(mesh.indices.empty());
    return mesh.reason;
  };
  CHECK(reason(collada(), ".dae") == "has no triangles");
  CHECK(reason("v 0 0 0\n", ".obj") == "has no triangles");
  CHECK(reason("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", ".obj") ==
        "refers to points that come later in the file");
  CHECK(reason(binary_stl().substr(0, 100), ".stl").starts_with("is broken: "));
  CHECK(reason("", ".stl") == "is of an unknown format");
}

TEST_CASE("mesh: the format is told from the bytes") {
  // A binary file may begin like an ASCII one.
  const MeshFacts solid = read_mesh(binary_stl("solid box"), ".stl");
  check_box(solid, MeshFormat::stl_binary, 36);
  CHECK(solid.named_solid);
  CHECK(read_mesh(obj(), ".stl").format == MeshFormat::obj);
  CHECK(read_mesh("<<<<<<< HEAD\n" + obj(), ".obj").format == MeshFormat::obj);
  CHECK(read_mesh(collada(), ".stl").format == MeshFormat::collada);
  CHECK(read_mesh("version https://git-lfs.github.com/spec/v1\n", ".stl").format ==
        MeshFormat::lfs_pointer);
  CHECK(read_mesh("glTF\2\0\0\0", ".glb").format == MeshFormat::gltf);
  CHECK(read_mesh("<!DOCTYPE html><html></html>", ".stl").format == MeshFormat::unknown);
  CHECK(read_mesh("", ".stl").format == MeshFormat::unknown);
}

TEST_CASE("mesh: turned inside out, and open") {
  std::string inside_out = obj();
  for (std::size_t at = 0; (at = inside_out.find("\nf", at)) != std::string::npos; ++at) {
    const std::size_t end = inside_out.find('\n', at + 1);
    const std::string face = inside_out.substr(at + 3, end - at - 3);
    const std::size_t first = face.find(' ');
    const std::size_t last = face.rfind(' ');
    inside_out.replace(at + 3, face.size(),
                       face.substr(last + 1) + face.substr(first, last - first) + " " +
                           face.substr(0, first));
  }
  const MeshFacts facts = read_mesh(inside_out, ".obj");
  REQUIRE(facts.solid);
  CHECK(facts.solid->volume == doctest::Approx(-6));

  const std::string whole = obj();
  const MeshFacts open = read_mesh(whole.substr(0, whole.rfind('f')), ".obj");
  CHECK(open.triangles == 11);
  CHECK(!open.solid);
  CHECK(facts.closure == Closure::closed);
  CHECK(open.closure == Closure::open);

  // One face inward, as in the mesh turned inside out.
  const std::size_t last = whole.rfind("\nf");
  const MeshFacts flipped =
      read_mesh(whole.substr(0, last) + inside_out.substr(inside_out.rfind("\nf")), ".obj");
  CHECK(flipped.closure == Closure::flipped);
  CHECK(!flipped.solid);
}

TEST_CASE("mesh: other ways to write OBJ") {
  const MeshFacts facts = read_mesh(
      "mtllib my colours.mtl\r\nv 0 0 0\r\nv 1 0 0 1.0\r\nv 1 1 0 0.5 0.5 0.5\r\nv 0 1 0\r\n"
      "f -4 -3 \\\r\n -2/1/1 -1\r\nusemtl none\r\n",
      ".obj");
  CHECK(!facts.defect);
  CHECK(facts.triangles == 2);
  CHECK(facts.vertices == 4);
  REQUIRE(facts.dependencies.size() == 1);
  CHECK(facts.dependencies[0].filename == "my colours.mtl");
  // Faces may come first.
  CHECK(defect("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n") == "none");
}

TEST_CASE("mesh: textures of a material library") {
  const auto textures = read_material_library(
      "newmtl a\nKd 1 0 0\nmap_Kd wood grain.png\nmap_Bump -bm 0.2 bump.png\n");
  REQUIRE(textures.size() == 1);
  CHECK(textures[0].filename == "wood grain.png");
  CHECK(textures[0].line == 3);
}

TEST_CASE("mesh: what is broken, and where") {
  const std::string stl = binary_stl();
  CHECK(defect(stl.substr(0, 300), ".stl") ==
        "0: its header announces 12 triangles, which take 684 bytes, but the file has 300");
  CHECK(defect(stl + "x", ".stl") ==
        "0: its header announces 12 triangles, which take 684 bytes, but the file has 685");
  CHECK(defect(stl.substr(0, 83), ".stl") == "0: the file ends inside its header of 84 bytes");
  std::string nan = stl;
  nan.replace(84 + 50 + 12, 4, "\xFF\xFF\xFF\x7F");
  CHECK(defect(nan, ".stl") == "0: a vertex of triangle 2 is not a number");

  CHECK(defect(replaced(ascii_stl(), "vertex 0.000000 0", "vertex nan 0")) ==
        "4: `nan` stands where a number is expected");
  CHECK(defect(replaced(ascii_stl(), "endloop", "")) ==
        "8: `endfacet` stands where `endloop` is expected");
  CHECK(defect("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n") ==
        "5: the file ends where `vertex` is expected");

  CHECK(defect(replaced(obj(), "f 1//1", "f 9//1")) ==
        "13: a face uses vertex 9, but the file has only 8");
  CHECK(defect(replaced(obj(), "f 1//1", "f 0//1")) ==
        "13: the corner `0//1` of a face is not an index");
  CHECK(defect("v 0 0 0\nf -2 1 1\n") ==
        "2: a face uses vertex -2, but the file has only 1 before it");
  CHECK(defect("v 0 0\n") == "1: a vertex has fewer than three coordinates");
  CHECK(defect("v 0 0 1,5\n") == "1: the coordinate `1,5` is not a number");
  CHECK(defect("v 0 0 0\nf 1 1\n") == "2: a face has fewer than three corners");

  std::string index = bobj();
  index[8 * 16 + 16 + 4] = 9;
  CHECK(defect(index) == "0: a triangle names the vertex 9, but 8 precede it");
  std::string normal = bobj();
  normal[8 * 16 + 16 + 12] = 0;
  CHECK(defect(normal) == "0: a triangle names the normal 0, but 1 precede it");
  CHECK(defect(bobj() + "....") == "0: there is no record of kind 774778414");
  CHECK(defect(bobj().substr(0, 100)) == "0: the file ends inside a record");
  std::string chunk;
  for (int i = 0; i < 16; ++i) chunk += bobj().substr(0, 16);
  CHECK(defect(chunk) ==
        "0: its size is a multiple of 256 bytes, of which MARS loses the last triangle");

  CHECK(defect(replaced(collada(), "</mesh>", "")).substr(0, 4) == "10: ");
  CHECK(defect(replaced(collada(), "10 0 0", "10 0")) ==
        "12: the transform of a node is not a list of numbers");
  CHECK(defect(replaced(collada(), " 0.000000", " x")) ==
        "7: some coordinates of the vertices are not numbers");
}

TEST_CASE("mesh: files cut short and bytes changed at random") {
  MESSAGE("seed " << test::seed());
  test::Random random;
  const std::pair<std::string, std::string> meshes[] = {{binary_stl(), ".stl"},
                                                        {ascii_stl(), ".stl"},
                                                        {obj(), ".obj"},
                                                        {bobj(), ".bobj"},
                                                        {collada(), ".dae"}};
  for (const auto& mesh : meshes) {
    const std::string &whole = mesh.first, &extension = mesh.second;
    CAPTURE(extension);
    const auto check = [&](const std::string& bytes) {
      const MeshFacts facts = read_mesh(bytes, extension);
      CHECK(facts.bytes == bytes.size());
      if (facts.defect) CHECK(!facts.defect->what.empty());
      if (facts.defect) CHECK(facts.defect->offset <= bytes.size());
      if (!facts.box) return;
      for (std::size_t i = 0; i < 3; ++i) CHECK(facts.box->low[i] <= facts.box->high[i]);
    };
    for (std::size_t size = 0; size < whole.size(); ++size) check(whole.substr(0, size));
    for (int round = 0; round < 2000; ++round) {
      std::string bytes = whole;
      for (std::size_t changes = 1 + random.below(8); changes > 0; --changes) {
        const std::size_t at = random.below(bytes.size());
        switch (random.below(3)) {
        case 0: bytes[at] = static_cast<char>(random.below(256)); break;
        case 1: bytes.erase(at, 1 + random.below(20)); break;
        default: bytes.insert(at, whole, random.below(whole.size()), random.below(40)); break;
        }
        if (bytes.empty()) bytes = " ";
      }
      check(bytes);
    }
  }
}
