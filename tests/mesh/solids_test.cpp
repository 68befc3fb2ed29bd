// SPDX-License-Identifier: BSD-3-Clause
// Volume, centre and second moments of random closed meshes, compared with the triangles that
// assimp reads, integrated with Eigen.
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <sstream>

#include "mesh/mesh_reader.hpp"
#include "support/temporary_folder.hpp"
#include "unit/random.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

struct Mesh {
  std::vector<std::array<float, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A closed surface like a ball with lumps, or like a ring.
Mesh random_mesh(Random& random) {
  Mesh mesh;
  const bool is_ring = random.below(3) == 0;
  const std::size_t rows = 3 + random.below(12);
  const std::size_t columns = 3 + random.below(12);
  const Eigen::Vector3d center(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  const double size = std::pow(10.0, random.between(-2, 1));
  const Eigen::Vector3d stretch(size * random.between(0.2, 1), size * random.between(0.2, 1), size);
  const auto add = [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d placed = center + stretch.cwiseProduct(point) * random.between(0.8, 1);
    mesh.points.push_back({static_cast<float>(placed.x()), static_cast<float>(placed.y()),
                           static_cast<float>(placed.z())});
  };
  const double turn = 2 * std::acos(-1.0);
  for (std::size_t r = 0; r < rows; ++r) {
    const auto row = static_cast<double>(r);
    const double v = is_ring ? turn * row / static_cast<double>(rows)
                             : turn / 2 * (row + 1) / static_cast<double>(rows + 1);
    for (std::size_t c = 0; c < columns; ++c) {
      const double u = turn * static_cast<double>(c) / static_cast<double>(columns);
      const double radius = is_ring ? 1 + 0.4 * std::cos(v) : std::sin(v);
      const double height = is_ring ? -0.4 * std::sin(v) : std::cos(v);
      add({radius * std::cos(u), radius * std::sin(u), height});
    }
  }
  const auto index = [&](std::size_t r, std::size_t c) {
    return static_cast<std::uint32_t>(r % rows * columns + c % columns);
  };
  for (std::size_t r = 0; r + (is_ring ? 0 : 1) < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      mesh.triangles.push_back({index(r, c), index(r + 1, c), index(r + 1, c + 1)});
      mesh.triangles.push_back({index(r, c), index(r + 1, c + 1), index(r, c + 1)});
    }
  }
  if (is_ring) return mesh;
  const auto top = static_cast<std::uint32_t>(mesh.points.size());
  add({0, 0, 1});
  add({0, 0, -1});
  for (std::size_t c = 0; c < columns; ++c) {
    mesh.triangles.push_back({top, index(0, c), index(0, c + 1)});
    mesh.triangles.push_back({top + 1, index(rows - 1, c + 1), index(rows - 1, c)});
  }
  return mesh;
}

template <class Number>
void put(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof number);
}

std::string as_stl(const Mesh& mesh) {
  std::string bytes(80, ' ');
  put(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) put(bytes, 0.0F);
    for (const std::uint32_t corner : triangle) {
      for (const float coordinate : mesh.points[corner]) put(bytes, coordinate);
    }
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string as_obj(const Mesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  for (const auto& p : mesh.points) text << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& t : mesh.triangles) {
    text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  return text.str();
}

std::string as_collada(const Mesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" )"
          R"(version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset><library_geometries>)"
          R"(<geometry id="g"><mesh><source id="p"><float_array id="a" count=")"
       << 3 * mesh.points.size() << R"(">)";
  for (const auto& p : mesh.points) text << p[0] << ' ' << p[1] << ' ' << p[2] << ' ';
  text << R"(</float_array><technique_common><accessor source="#a" count=")" << mesh.points.size()
       << R"(" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>)"
          R"(<param name="Z" type="float"/></accessor></technique_common></source>)"
          R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)"
          R"(<triangles count=")"
       << mesh.triangles.size() << R"("><input semantic="VERTEX" source="#v" offset="0"/><p>)";
  for (const auto& t : mesh.triangles) text << t[0] << ' ' << t[1] << ' ' << t[2] << ' ';
  text << R"(</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>)"
          R"(<visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>)"
          R"(</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
  return text.str();
}

/// Indices of four bytes, then points.
std::string as_glb(const Mesh& mesh) {
  std::string data;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) put(data, corner);
  }
  const std::size_t indices = data.size();
  for (const auto& point : mesh.points) {
    for (const float coordinate : point) put(data, coordinate);
  }
  const auto text = [](std::size_t number) { return std::to_string(number); };
  std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)"
                     R"({"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":1},)"
                     R"("indices":0}]}],"buffers":[{"byteLength":)" +
                     text(data.size()) + R"(}],"bufferViews":[{"buffer":0,"byteLength":)" +
                     text(indices) + R"(},{"buffer":0,"byteOffset":)" + text(indices) +
                     R"(,"byteLength":)" + text(data.size() - indices) +
                     R"(}],"accessors":[{"bufferView":0,"componentType":5125,"type":"SCALAR",)"
                     R"("count":)" +
                     text(3 * mesh.triangles.size()) +
                     R"(},{"bufferView":1,"componentType":5126,"type":"VEC3","count":)" +
                     text(mesh.points.size()) + R"(,"min":[-9e9,-9e9,-9e9],"max":[9e9,9e9,9e9]}]})";
  while (json.size() % 4 != 0) json += ' ';
  std::string bytes = "glTF";
  put(bytes, std::uint32_t{2});
  put(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
  put(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  put(bytes, static_cast<std::uint32_t>(data.size()));
  bytes += std::string("BIN\0", 4) + data;
  return bytes;
}

struct Sums {
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};

/// By the covariance of the unit tetrahedron, transformed by the matrix of the corners (Blow and
/// Binstock): another way than that of the library.
void add(Sums& sums, const Eigen::Matrix3d& corners) {
  Eigen::Matrix3d unit;
  unit << 2, 1, 1, 1, 2, 1, 1, 1, 2;
  const double determinant = corners.determinant();
  sums.volume += determinant / 6;
  sums.first += determinant / 24 * corners.rowwise().sum();
  sums.second += determinant / 120 * corners * unit * corners.transpose();
}

/// Of the triangles as written: assimp rounds decimal numbers of COLLADA in its own way.
Sums integrate(const Mesh& mesh) {
  Sums sums;
  for (const auto& triangle : mesh.triangles) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) {
      const auto& point = mesh.points[triangle[static_cast<std::size_t>(k)]];
      corners.col(k) = Eigen::Vector3d(point[0], point[1], point[2]);
    }
    add(sums, corners);
  }
  return sums;
}

Sums integrate(const std::string& path, bool turns_y_to_z) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene =
      importer.ReadFile(path, aiProcess_Triangulate | aiProcess_PreTransformVertices);
  REQUIRE(scene != nullptr);
  REQUIRE(scene->mNumMeshes == 1);
  const aiMesh& mesh = *scene->mMeshes[0];
  const auto point = [&](unsigned index) {
    const aiVector3D& p = mesh.mVertices[index];
    return turns_y_to_z ? Eigen::Vector3d(p.x, -p.z, p.y) : Eigen::Vector3d(p.x, p.y, p.z);
  };
  Sums sums;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const unsigned* corners = mesh.mFaces[f].mIndices;
    Eigen::Matrix3d sides;
    sides << point(corners[0]), point(corners[1]), point(corners[2]);
    add(sums, sides);
  }
  return sums;
}

void check_same(const MeshFacts& facts, const Sums& theirs) {
  constexpr double kPrecision = 1e-9;
  CHECK(facts.closure == Closure::closed);
  REQUIRE(facts.solid);
  const Solid& ours = *facts.solid;
  CHECK(ours.volume > 0);
  CHECK(std::fabs(ours.volume - theirs.volume) <= kPrecision * theirs.volume);
  const Eigen::Vector3d center = theirs.first / theirs.volume;
  const Eigen::Matrix3d about = theirs.second - theirs.volume * center * center.transpose();
  const double reach = std::sqrt(theirs.second.trace() / theirs.volume);
  for (int i = 0; i < 3; ++i) {
    CHECK(std::fabs(ours.center[static_cast<std::size_t>(i)] - center[i]) <= kPrecision * reach);
  }
  const double second[] = {about(0, 0), about(1, 1), about(2, 2),
                           about(0, 1), about(0, 2), about(1, 2)};
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK(std::fabs(ours.second[k] - second[k]) <= kPrecision * theirs.second.trace());
  }
}

}  // namespace

TEST_CASE("solids: 200 closed meshes have the moments of the triangles that assimp reads") {
  const std::pair<std::string, std::function<std::string(const Mesh&)>> writers[] = {
      {".stl", as_stl}, {".obj", as_obj}, {".dae", as_collada}, {".glb", as_glb}};
  Random random;
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < 200; ++i) {
    const Mesh mesh = random_mesh(random);
    const auto& [name, write] = writers[i % std::size(writers)];
    const std::string extension = name;  // a binding cannot be captured
    const std::string bytes = write(mesh);
    const std::string path = folder / ("m" + extension);
    std::ofstream(path, std::ios::binary) << bytes;
    CAPTURE(i);
    CAPTURE(seed());
    CAPTURE(extension);
    const Sums theirs =
        extension == ".dae" ? integrate(mesh) : integrate(path, extension == ".glb");
    check_same(read_mesh(bytes, extension), theirs);
  }
}
