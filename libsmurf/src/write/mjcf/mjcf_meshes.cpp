// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf/mjcf_meshes.hpp"

#include <algorithm>
#include <cmath>

#include "base/files/path.hpp"
#include "base/numbers/floating.hpp"
#include "base/numbers/little_endian.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/vectors.hpp"
#include "link/mujoco_compiler.hpp"
#include "mesh/mesh_reader.hpp"

namespace smurf {
namespace {

bool is_named_for_mujoco(const FlatMesh& mesh) {
  const std::string extension = path::to_lower(path::extension(mesh.file));
  return extension == ".stl" || extension == ".obj";
}

/// MuJoCo reads only binary STL without other bytes after the triangles.
bool is_stl_of_mujoco(std::string_view bytes) {
  constexpr std::size_t kCountAt = 80;
  constexpr std::size_t kHeader = 84;
  constexpr std::size_t kTriangle = 50;
  if (bytes.size() < kHeader) return false;
  const std::size_t triangles = read_uint32(bytes, kCountAt);
  return triangles <= kMostStlTrianglesOfMujoco && bytes.size() == kHeader + kTriangle * triangles;
}

using Point = std::array<float, 3>;

Vector3 between(const Point& a, const Point& b) {
  return difference({b[0], b[1], b[2]}, {a[0], a[1], a[2]});
}

/// All points are in one plane, so they enclose no volume.
bool is_flat(const std::vector<Point>& points) {
  constexpr double kThin = 1e-12;  // of a square of lengths
  Vector3 along{};
  Vector3 normal{};
  for (const Point& point : points) {
    const Vector3 to = between(points.front(), point);
    if (dot(to, to) > dot(along, along)) along = to;
  }
  for (const Point& point : points) {
    const Vector3 area = cross(along, between(points.front(), point));
    if (dot(area, area) > dot(normal, normal)) normal = area;
  }
  const double least = kThin * dot(normal, normal) * dot(along, along);
  return std::all_of(points.begin(), points.end(), [&](const Point& point) {
    const double height = dot(normal, between(points.front(), point));
    return height * height <= least;
  });
}

/// The volume as MuJoCo computes it: of the tetrahedra between the triangles and the centre of the
/// surface, whatever the side that a triangle faces.
double volume_of(const MeshTriangles& mesh) {
  const auto point = [&](std::size_t at) -> Vector3 {
    const Point& p = mesh.points[mesh.indices[at]];
    return {p[0], p[1], p[2]};
  };
  Vector3 center{};
  double total_area = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vector3 normal =
        cross(difference(point(i + 1), point(i)), difference(point(i + 2), point(i)));
    const double area = std::sqrt(dot(normal, normal));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      center[axis] += area * (point(i)[axis] + point(i + 1)[axis] + point(i + 2)[axis]) / 3;
    }
    total_area += area;
  }
  if (!(total_area > 0)) return 0;
  for (double& coordinate : center) coordinate /= total_area;
  double volume = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vector3 normal =
        cross(difference(point(i + 1), point(i)), difference(point(i + 2), point(i)));
    volume += std::abs(dot(normal, difference(point(i), center))) / 6;
  }
  return volume;
}

/// MuJoCo refuses a volume below mjMINVAL.
bool has_volume(double volume, const Vector3& scale) {
  constexpr double kLeastVolume = 1e-14;
  return volume * std::abs(scale[0] * scale[1] * scale[2]) > kLeastVolume;
}

}  // namespace

bool is_mesh_of_mujoco(std::string_view extension, std::string_view bytes) {
  if (extension == ".stl") return is_stl_of_mujoco(bytes);
  return extension == ".obj" && !has_faces_after_first_group(bytes);
}

std::string MjcfMeshes::key_of(const FlatMesh& mesh) {
  return mesh.file + " " + join_numbers(mesh.scale);
}

std::string MjcfMeshes::declare(const FlatMesh& mesh, Span place) {
  const std::string& file = files_.first_name(mesh.file);
  const auto [known, is_new] = mesh_files_.try_emplace(file);
  MeshOfFile& of_file = known->second;
  if (!of_file.reason.empty()) return of_file.reason;
  if (is_new) examine(mesh, of_file);
  MeshTriangles triangles;
  if (!of_file.is_named) {
    triangles = files_.read(file, place);
  } else if (is_new && of_file.is_readable) {
    triangles = scene_.meshes.triangles(file, TexturePoints::ignored);
  }
  if (triangles.reason.empty() && !triangles.points.empty() && is_new) {
    if (is_flat(triangles.points)) triangles.reason = "is flat, which MuJoCo refuses";
    of_file.volume = volume_of(triangles);
    of_file.has_textures = triangles.has_textures;
    for (const MeshPart& part : triangles.parts) of_file.colors.push_back(part.color);
  }
  if (!triangles.reason.empty()) return of_file.reason = triangles.reason;
  const Vector3& scale = mesh.scale;
  if (of_file.volume && !has_volume(*of_file.volume, scale)) {
    return "has too little volume for MuJoCo";
  }
  const std::string mesh_name = new_name();
  if (of_file.is_named) {
    xml_.empty("mesh", {{"name", mesh_name}, {"file", mesh.file}, {"scale", join_numbers(scale)}});
  } else {
    declare_triangles(mesh_name, scale, triangles);
  }
  names_.emplace(key_of(mesh), mesh_name);
  return {};
}

/// Decided by the extension and the content: of an OBJ, MuJoCo reads the faces of the first group
/// only. A file that may not be read here, such
/// as one outside of the project, may be sound.
void MjcfMeshes::examine(const FlatMesh& mesh, MeshOfFile& of_file) const {
  of_file.is_named = is_named_for_mujoco(mesh);
  if (!of_file.is_named || !scene_.meshes.image || !scene_.meshes.triangles) return;
  const FileContent content = scene_.meshes.image(mesh.file);
  of_file.is_readable = content.status == ReadStatus::ok || content.status == ReadStatus::not_found;
  if (content.status != ReadStatus::ok) return;
  of_file.is_named =
      smurf::is_mesh_of_mujoco(path::to_lower(path::extension(mesh.file)), content.text);
}

void MjcfMeshes::declare_triangles(const std::string& name, const Vector3& scale,
                                   const MeshTriangles& triangles) {
  std::string points;
  for (const std::array<float, 3>& point : triangles.points) {
    for (const float coordinate : point) {
      if (!points.empty()) points += ' ';
      points += shortest(coordinate);
    }
  }
  std::string faces;
  for (const std::uint32_t index : triangles.indices) {
    if (!faces.empty()) faces += ' ';
    faces += std::to_string(index);
  }
  xml_.empty("mesh", {{"name", name},
                      {"vertex", std::move(points)},
                      {"face", std::move(faces)},
                      {"scale", join_numbers(scale)}});
}

const std::string* MjcfMeshes::name_of(const FlatMesh& mesh) const {
  const auto known = names_.find(key_of(mesh));
  return known != names_.end() ? &known->second : nullptr;
}

const std::vector<MjcfMeshes::Part>* MjcfMeshes::parts_of(const FlatMesh& mesh) const {
  const auto known = parts_.find(key_of(mesh));
  return known != parts_.end() ? &known->second : nullptr;
}

std::vector<MeshTriangles> MjcfMeshes::split(const FlatMesh& mesh, Span place) {
  const MeshTriangles all = files_.read(files_.first_name(mesh.file), place);
  std::vector<MeshTriangles> split;
  for (std::size_t i = 0; i < all.parts.size(); ++i) {
    const bool is_last = i + 1 == all.parts.size();
    const auto range = [](const auto& list, std::size_t first, std::size_t end) {
      return std::vector(list.begin() + static_cast<std::ptrdiff_t>(first),
                         list.begin() + static_cast<std::ptrdiff_t>(end));
    };
    const std::uint32_t first_point = all.parts[i].first_point;
    MeshTriangles part;
    part.points =
        range(all.points, first_point, is_last ? all.points.size() : all.parts[i + 1].first_point);
    part.indices = range(all.indices, all.parts[i].first_index,
                         is_last ? all.indices.size() : all.parts[i + 1].first_index);
    for (std::uint32_t& index : part.indices) index -= first_point;
    if (part.points.empty() || is_flat(part.points) || !has_volume(volume_of(part), mesh.scale)) {
      return {};
    }
    split.push_back(std::move(part));
  }
  return split;
}

void MjcfMeshes::declare_parts(const FlatMesh& mesh, Span place) {
  const MeshOfFile& of_file = mesh_files_[files_.first_name(mesh.file)];
  if (of_file.has_textures) losses_.note("textures", place, mesh.file);
  const bool has_colors = std::any_of(of_file.colors.begin(), of_file.colors.end(),
                                      [](const auto& color) { return color.has_value(); });
  const auto [known, is_new] = parts_.try_emplace(key_of(mesh));
  if (!has_colors || !is_new) return;
  std::vector<Part>& parts = known->second;
  if (of_file.colors.size() == 1) {
    parts.push_back({*name_of(mesh), of_file.colors.front()});
    return;
  }
  const std::vector<MeshTriangles> all = split(mesh, place);
  if (all.size() != of_file.colors.size()) {
    losses_.note(kColorsOfMeshes, place, mesh.file);
    return;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    parts.push_back({new_name(), of_file.colors[i]});
    declare_triangles(parts.back().name, mesh.scale, all[i]);
  }
}

}  // namespace smurf
