// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/little_endian.hpp"
#include "base/numbers/vectors.hpp"
#include "base/text/quoted.hpp"
#include "mesh/quickhull.hpp"
#include "mjcf/model.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf::mjcf {
namespace {

Vector3 sum(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector3 times(const Vector3& a, double by) { return {a[0] * by, a[1] * by, a[2] * by}; }

struct Triangle {
  Vector3 a, b, c;
  Vector3 center() const { return times(sum(sum(a, b), c), 1.0 / 3); }
  Vector3 area() const { return times(cross(difference(b, a), difference(c, a)), 0.5); }
};

Triangle triangle(const Triangles& mesh, std::size_t i, const Vector3& about) {
  const auto& f = mesh.faces[i];
  return {difference(mesh.points[f[0]], about), difference(mesh.points[f[1]], about),
          difference(mesh.points[f[2]], about)};
}

/// The signed volume of the pyramid over a triangle, with its top at the origin; or the area of the
/// triangle.
double amount_of(const Triangle& t, MeshInertia mode) {
  const Vector3 area = t.area();
  if (mode == MeshInertia::shell) return std::sqrt(dot(area, area));
  const double volume = dot(t.center(), area) / 3;
  return mode == MeshInertia::legacy ? std::fabs(volume) : volume;
}

/// A mesh of MuJoCo's old format: counts, then points, normals, texture points and faces.
std::optional<Triangles> read_msh(std::string_view bytes) {
  if (bytes.size() < 16) return std::nullopt;
  const std::uint64_t points = read_uint32(bytes, 0);
  const std::uint64_t normals = read_uint32(bytes, 4);
  const std::uint64_t textures = read_uint32(bytes, 8);
  const std::uint64_t faces = read_uint32(bytes, 12);
  if (bytes.size() != 16 + 12 * points + 12 * normals + 8 * textures + 12 * faces)
    return std::nullopt;
  Triangles result;
  for (std::uint64_t i = 0; i < points; ++i) {
    const std::size_t at = 16 + 12 * i;
    result.points.push_back(
        {read_float(bytes, at), read_float(bytes, at + 4), read_float(bytes, at + 8)});
  }
  const std::size_t first = 16 + 12 * points + 12 * normals + 8 * textures;
  for (std::uint64_t i = 0; i < faces; ++i) {
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      face[k] = read_uint32(bytes, first + 12 * i + 4 * k);
      if (face[k] >= points) return std::nullopt;
    }
    result.faces.push_back(face);
  }
  return result;
}

/// The hull of points; empty if they lie in a plane.
Triangles hull_of(std::vector<Vector3> points) {
  double reach = 0;
  for (const Vector3& point : points) {
    for (const double x : point) reach = std::max(reach, std::fabs(x));
  }
  Triangles result;
  // As exact as rounding errors let it be.
  for (const double tolerance : {1e-10, 1e-9, 1e-8, 1e-7}) {
    const auto faces = quickhull(points, tolerance * reach);
    if (!faces) continue;
    for (const HullFace& face : *faces) result.faces.push_back(face.corners);
    break;
  }
  result.points = std::move(points);
  return result;
}

}  // namespace

std::optional<MassProperties> properties_of(const Triangles& mesh, MeshInertia mode) {
  if (mode == MeshInertia::convex) return properties_of(hull_of(mesh.points), MeshInertia::exact);
  // The mean of the centres of the faces, by area.
  Vector3 middle{};
  double area = 0;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Triangle t = triangle(mesh, i, {});
    const double one = amount_of(t, MeshInertia::shell);
    middle = sum(middle, times(t.center(), one));
    area += one;
  }
  if (!(area > 0)) return std::nullopt;
  middle = times(middle, 1 / area);
  MassProperties result;
  if (mode == MeshInertia::shell) {
    result.center = middle;
  } else {
    double volume = 0;
    Vector3 center{};
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      const Triangle t = triangle(mesh, i, middle);
      const double one = amount_of(t, mode);
      volume += one;
      center = sum(center, times(t.center(), one * 0.75));
    }
    if (!(std::fabs(volume) > 1e-15)) return std::nullopt;
    if (volume < 0) return std::nullopt;
    result.center = sum(middle, times(center, 1 / volume));
  }
  std::array<double, 6> products{};
  constexpr std::size_t kPairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Triangle t = triangle(mesh, i, result.center);
    const double one = amount_of(t, mode);
    result.mass += one;
    for (std::size_t k = 0; k < 6; ++k) {
      const auto [x, y] = kPairs[k];
      products[k] +=
          one / (mode == MeshInertia::shell ? 12 : 20) *
          (2 * (t.a[x] * t.a[y] + t.b[x] * t.b[y] + t.c[x] * t.c[y]) + t.a[x] * t.b[y] +
           t.a[y] * t.b[x] + t.a[x] * t.c[y] + t.a[y] * t.c[x] + t.b[x] * t.c[y] + t.b[y] * t.c[x]);
    }
  }
  result.inertia = {products[1] + products[2],
                    products[0] + products[2],
                    products[0] + products[1],
                    -products[3],
                    -products[4],
                    -products[5]};
  return result;
}

void Meshes::list(const ModelFile& file) {
  if (!listed_.emplace(&file, true).second) return;
  file.each_in("asset", [&](View one) {
    if (one.name() != "mesh") return;
    const DefaultClass* of_class = file.class_of(one, nullptr);
    const Attribute* name = one.attribute("name");
    const Attribute* path = one.attribute("file");
    const std::string own(name != nullptr   ? name->value()
                          : path != nullptr ? path::stem(path->value())
                                            : std::string_view());
    if (own.empty()) {
      reporter_.refuse(one.name_span(), "a mesh needs a `name` or a `file`", "write one of them");
      return;
    }
    Mesh mesh;
    mesh.settings = Settings(one, of_class);
    if (path != nullptr) {
      std::string_view written = path->value();
      if (file.compiler().strippath) written = path::file_name(written);
      mesh.path = path::join(path::join(file.folder(), file.compiler().meshdir), written);
    }
    const bool is_new = meshes_.emplace(Key{&file, own}, std::move(mesh)).second;
    if (!is_new)
      reporter_.refuse((name != nullptr ? name : path)->value_span(),
                       "there is another mesh with the name " + quoted(own),
                       "rename one of the two");
  });
  for (auto& [key, mesh] : meshes_) {
    if (key.first == &file) read(file, mesh);
  }
}

void Meshes::read(const ModelFile&, Mesh& mesh) {
  const Settings& s = mesh.settings;
  s.numbers("scale", mesh.scale, 3, reporter_);
  Vector3 position{};
  s.numbers("refpos", position, 3, reporter_);
  std::array<double, 4> q{1, 0, 0, 0};
  s.numbers("refquat", q, 4, reporter_);
  Quaternion turn{q[0], q[1], q[2], q[3]};
  if (!(norm(turn) > 1e-14)) {
    reporter_.refuse(s.place({"refquat"}).origin, "the quaternion is zero",
                     "write numbers that give a direction");
    turn = {};
  }
  if (const Attribute* inertia = s.find("inertia")) {
    constexpr std::string_view kModes[] = {"convex", "exact", "legacy", "shell"};
    mesh.mode = static_cast<MeshInertia>(word_of(*inertia, kModes, reporter_).value_or(2));
  }
  const Pose reference{position, normalized(turn)};
  mesh.origin = inverse(reference);
  for (std::size_t i = 0; i < 3; ++i) mesh.origin.position[i] *= mesh.scale[i];
  const bool is_uniform = mesh.scale[0] == mesh.scale[1] && mesh.scale[1] == mesh.scale[2];
  mesh.is_sheared = !is_uniform && !(reference.orientation == Quaternion{});
}

std::optional<Triangles> Meshes::triangles_of(const Mesh& mesh) {
  Triangles result;
  const Settings& s = mesh.settings;
  if (const Attribute* vertices = s.element().attribute("vertex")) {
    const auto numbers =
        numbers_of(*vertices, 0, std::numeric_limits<std::size_t>::max(), reporter_);
    if (numbers.size() % 3 != 0)
      reporter_.refuse(vertices->value_span(), "the number of coordinates is no multiple of 3",
                       "write three for each point");
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
      result.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    if (const Attribute* faces = s.element().attribute("face")) {
      const auto corners =
          numbers_of(*faces, 0, std::numeric_limits<std::size_t>::max(), reporter_);
      for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        std::array<std::uint32_t, 3> face{};
        bool is_known = true;
        for (std::size_t k = 0; k < 3; ++k) {
          is_known = is_known && corners[i + k] >= 0 &&
                     corners[i + k] < static_cast<double>(result.points.size());
          face[k] = is_known ? static_cast<std::uint32_t>(corners[i + k]) : 0;
        }
        if (!is_known) {
          reporter_.refuse(faces->value_span(), "a face names a point that is not there",
                           "write numbers of points, from 0 on");
          return std::nullopt;
        }
        result.faces.push_back(face);
      }
    } else {
      result = hull_of(result.points);
    }
    return result;
  }
  if (mesh.path.empty()) {
    reporter_
        .miss(s.element().name_span(),
              "only MuJoCo knows the triangles of this mesh, so the mass of its bodies is unknown",
              "write `<inertial>` into the bodies, or the mesh into a file")
        .when(cases::kMadeByMujoco);
    return std::nullopt;
  }
  Context& context = reporter_.context();
  const std::string extension = path::to_lower(path::extension(mesh.path));
  FileContent content = context.files.read(mesh.path, context.limits.mesh_bytes);
  if (content.status != ReadStatus::ok) {
    const Place place = s.place({"file"});
    reporter_.miss(place.origin,
                   "cannot read " + quoted(mesh.path) +
                       ", so the mass of its bodies is unknown: " + content.reason,
                   "correct the path, or write `<inertial>` into the bodies");
    return std::nullopt;
  }
  if (extension == ".msh") {
    auto read = read_msh(content.text);
    if (!read)
      reporter_.refuse(s.place({"file"}).origin, quoted(mesh.path) + " is no mesh of MuJoCo",
                       "correct the file");
    return read;
  }
  const MeshTriangles read = read_triangles(content.text, extension);
  if (!read.reason.empty()) {
    reporter_.miss(s.place({"file"}).origin,
                   quoted(mesh.path) + " " + read.reason + ", so the mass of its bodies is unknown",
                   "correct the file, or write `<inertial>` into the bodies");
    return std::nullopt;
  }
  for (const auto& p : read.points) result.points.push_back({p[0], p[1], p[2]});
  for (std::size_t i = 0; i + 2 < read.indices.size(); i += 3)
    result.faces.push_back({read.indices[i], read.indices[i + 1], read.indices[i + 2]});
  return result;
}

const Mesh* Meshes::find(const ModelFile& file, const std::string& name, bool needs_mass) {
  list(file);
  const auto found = meshes_.find({&file, name});
  if (found == meshes_.end()) return nullptr;
  Mesh& mesh = found->second;
  if (!needs_mass || mesh.is_read) return &mesh;
  mesh.is_read = true;
  auto triangles = triangles_of(mesh);
  if (!triangles) return &mesh;
  for (Vector3& p : triangles->points) {
    // MuJoCo keeps points as float.
    const Vector3 scaled{p[0] * mesh.scale[0], p[1] * mesh.scale[1], p[2] * mesh.scale[2]};
    const Pose& o = mesh.origin;
    if (mesh.is_sheared) {
      Pose unscaled = o;
      for (std::size_t i = 0; i < 3; ++i)
        unscaled.position[i] /= mesh.scale[i] != 0 ? mesh.scale[i] : 1;
      const Vector3 turned = sum(unscaled.position, rotate(o.orientation, p));
      p = {turned[0] * mesh.scale[0], turned[1] * mesh.scale[1], turned[2] * mesh.scale[2]};
    } else {
      p = sum(o.position, rotate(o.orientation, scaled));
    }
    for (double& one : p) one = static_cast<double>(static_cast<float>(one));
  }
  if (mesh.scale[0] * mesh.scale[1] * mesh.scale[2] < 0) {
    for (auto& face : triangles->faces) std::swap(face[0], face[1]);
  }
  mesh.properties = properties_of(*triangles, mesh.mode);
  mesh.is_refused = !mesh.properties;
  if (!mesh.properties) return &mesh;
  const Pose X =
      inverse(Pose{mesh.properties->center, imports::principal_of(mesh.properties->inertia).axes});
  mesh.low = mesh.high = {};
  for (const Vector3& p : triangles->points) {
    const Vector3 at = sum(X.position, rotate(X.orientation, p));
    for (std::size_t i = 0; i < 3; ++i)
      mesh.low[i] = std::min(mesh.low[i], at[i]), mesh.high[i] = std::max(mesh.high[i], at[i]);
  }
  return &mesh;
}

}  // namespace smurf::mjcf
