// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/gltf_scene.hpp"

#include <cmath>
#include <vector>

namespace smurf::gltf {
namespace {

class Nodes {
 public:
  Nodes(Data& data, const MeshVisitor& visit) : data_(data), visit_(visit) {}

  void read() {
    const Json* nodes = member(data_.json(), "nodes");
    is_placed_.resize(nodes != nullptr && nodes->is_array() ? nodes->size() : 0);
    const Affine X_up{{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0}};
    if (!push_roots(X_up)) return;
    while (!left_.empty()) {
      const Placed placed = left_.back();
      left_.pop_back();
      if (!node(placed)) return;
    }
  }

 private:
  struct Placed {
    const Json* index;
    Affine X_MP;  ///< transform of the parent in the mesh
  };

  /// In reverse order, so that the first is handled first.
  bool push(const Json* indices, const Affine& X) {
    if (indices == nullptr) return true;
    if (!indices->is_array())
      return data_.fail_broken("the nodes of a scene or node are not a "
                               "list");
    for (std::size_t i = indices->size(); i-- > 0;) left_.push_back({&(*indices)[i], X});
    return true;
  }

  bool push_roots(const Affine& X) {
    const Json* shown = member(data_.json(), "scene");
    const Json first = 0U;
    if (shown == nullptr && member(data_.json(), "scenes") == nullptr) {
      return data_.fail_unread("has no scene that places its parts");
    }
    const Json* scene = data_.item("scenes", shown == nullptr ? &first : shown);
    return scene != nullptr && push(member(*scene, "nodes"), X);
  }

  bool node(const Placed& placed) {
    const Json* node = data_.item("nodes", placed.index);
    if (node == nullptr) return false;
    const auto index = static_cast<std::size_t>(*natural(placed.index));
    if (is_placed_[index]) return data_.fail_broken("a node is named twice");
    is_placed_[index] = true;
    Affine X = placed.X_MP;
    if (!transform(*node, X)) return data_.fail_broken("the transform of a node is invalid");
    if (const Json* mesh = member(*node, "mesh")) {
      if (member(*node, "skin") != nullptr) {
        return data_.fail_unread("has skins, which are not read");
      }
      const Json* named = data_.item("meshes", mesh);
      if (named == nullptr || !visit_(*named, *natural(mesh), X)) return false;
    }
    return push(member(*node, "children"), X);
  }

  static bool transform(const Json& node, Affine& X) {
    if (const Json* matrix = member(node, "matrix")) {
      double m[16];
      if (!read_numbers(matrix, m)) return false;
      Affine affine;
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
          affine.rows[4 * row + column] = m[4 * column + row];
        }
      }
      X = X * affine;
    }
    if (const Json* moved = member(node, "translation")) {
      Vector3 by;
      if (!read_numbers(moved, by)) return false;
      X = X * translation(by);
    }
    if (const Json* turned = member(node, "rotation")) {
      double q[4];
      if (!read_numbers(turned, q)) return false;
      const Quaternion by{q[3], q[0], q[1], q[2]};
      if (!(norm(by) > 0)) return false;
      X = X * rotation(normalized(by));
    }
    if (const Json* scaled = member(node, "scale")) {
      Vector3 by;
      if (!read_numbers(scaled, by)) return false;
      X = X * scaling(by);
    }
    return true;
  }

  Data& data_;
  const MeshVisitor& visit_;
  std::vector<bool> is_placed_;
  std::vector<Placed> left_;
};

bool is_finite(const Vector3& point) {
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

std::optional<Primitive> read(Data& data, const Json& written, std::uint64_t mode) {
  const Json* attributes = member(written, "attributes");
  const Json* position = attributes == nullptr ? nullptr : member(*attributes, "POSITION");
  if (position == nullptr) {
    data.fail_broken("a primitive has no points");
    return std::nullopt;
  }
  const auto points = data.accessor(position, "VEC3");
  if (!points) return std::nullopt;
  if (points->type != kFloat) {
    data.fail_broken("the points of a primitive are not floats");
    return std::nullopt;
  }
  const Json* written_indices = member(written, "indices");
  if (written_indices == nullptr) {
    return Primitive{*points, std::nullopt, points->count, mode, &written};
  }
  const auto indices = data.accessor(written_indices, "SCALAR");
  if (!indices) return std::nullopt;
  if (indices->type == kFloat) {
    data.fail_broken("the indices of a primitive are not integers");
    return std::nullopt;
  }
  return Primitive{*points, indices, indices->count, mode, &written};
}

}  // namespace

std::optional<Vector3> point_at(Data& data, const Primitive& primitive, std::uint64_t place) {
  if (place >= primitive.points.count) {
    data.fail_broken("the index " + std::to_string(place) + " names none of " +
                     std::to_string(primitive.points.count) + " points");
    return std::nullopt;
  }
  const Vector3 point = primitive.points.point(place);
  if (!is_finite(point)) {
    data.fail_broken("some coordinates of a point are not numbers");
    return std::nullopt;
  }
  return point;
}

bool visit_triangles(Data& data, const Primitive& primitive, const Affine& X,
                     const CornersVisitor& visit) {
  // If most points are corners, each is read once.
  std::vector<Vector3> points;
  if (primitive.points.count <= primitive.count) {
    points.reserve(primitive.points.count);
    for (std::uint64_t i = 0; i < primitive.points.count; ++i) {
      points.push_back(X * primitive.points.point(i));
    }
  }
  const std::uint64_t step = primitive.mode == kTriangles ? 3 : 1;
  for (std::uint64_t i = 0; i + 3 <= primitive.count; i += step) {
    const bool is_turned = primitive.mode == kStrip && i % 2 == 1;
    Corners corners{{},
                    {primitive.mode == kFan ? 0
                     : is_turned            ? i + 1
                                            : i,
                     is_turned ? i : i + 1, i + 2}};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t place = place_of(primitive, corners.places[k]);
      if (place < points.size() && is_finite(points[place])) {
        corners.points[k] = points[place];
        continue;
      }
      const auto point = point_at(data, primitive, place);
      if (!point) return false;
      corners.points[k] = X * *point;
    }
    if (!visit(corners)) return false;
  }
  return true;
}

void visit_meshes(Data& data, const MeshVisitor& visit) { Nodes(data, visit).read(); }

bool visit_primitives(Data& data, const Json& mesh, std::size_t& steps,
                      const PrimitiveVisitor& visit) {
  constexpr std::size_t kMostSteps = 4'000'000;
  const Json* primitives = member(mesh, "primitives");
  if (primitives == nullptr || !primitives->is_array()) {
    return data.fail_broken("a mesh has no primitives");
  }
  for (const Json& written : *primitives) {
    if (++steps > kMostSteps) return data.fail_unread(kRepeats);
    const Json* mode = member(written, "mode");
    const auto kind = mode == nullptr ? std::optional(kTriangles) : natural(mode);
    if (!kind || *kind > kFan) return data.fail_broken("a primitive has an unknown mode");
    if (*kind < kTriangles) continue;  // points and lines
    const auto primitive = read(data, written, *kind);
    if (!primitive) return false;
    if (primitive->mode == kTriangles && primitive->count % 3 != 0) {
      return data.fail_broken("a primitive ends inside a triangle");
    }
    if (!visit(*primitive)) return false;
  }
  return true;
}

}  // namespace smurf::gltf
