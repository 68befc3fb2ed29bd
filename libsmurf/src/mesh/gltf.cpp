// SPDX-License-Identifier: BSD-3-Clause
// The triangles of glTF 2.0, placed by the nodes of its scene. The y axis of glTF is up. It is
// turned to z, as RViz (ros2/rviz pull request 1482), Drake and Meshcat turn it; Gazebo does not.
#include <cmath>
#include <vector>

#include "mesh/affine.hpp"
#include "mesh/formats.hpp"
#include "mesh/gltf_data.hpp"

namespace smurf {
namespace {

using namespace gltf;

constexpr std::uint64_t kTriangles = 4;
constexpr std::uint64_t kStrip = 5;
constexpr std::uint64_t kFan = 6;

/// A part of the light of a colour as a value of a screen (sRGB).
double screen_value(double light) {
  const double c = std::fmin(std::fmax(light, 0), 1);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

class GltfTriangles {
 public:
  GltfTriangles(Data& data, TriangleCollector& triangles) : data_(data), triangles_(triangles) {}

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
    Affine X_MP;  ///< of the parent in the mesh
  };
  struct Primitive {
    Accessor points;
    std::optional<Accessor> indices;
    std::uint64_t count, mode;
  };

  /// In reverse, so that the first is the first to be taken.
  bool push(const Json* indices, const Affine& X) {
    if (indices == nullptr) return true;
    if (!indices->is_array()) return data_.fail_broken("the nodes of a scene or node are no list");
    for (std::size_t i = indices->size(); i-- > 0;) left_.push_back({&(*indices)[i], X});
    return true;
  }

  bool push_roots(const Affine& X) {
    const Json* shown = member(data_.json(), "scene");
    const Json first = 0U;
    if (shown == nullptr && member(data_.json(), "scenes") == nullptr) {
      return data_.fail_unread("has no scene that says where its parts are");
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
    if (!transform(*node, X)) return data_.fail_broken("the transform of a node is no transform");
    if (const Json* mesh = member(*node, "mesh")) {
      if (member(*node, "skin") != nullptr) {
        return data_.fail_unread("has skins, which are not read");
      }
      if (!place(data_.item("meshes", mesh), X)) return false;
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

  bool place(const Json* mesh, const Affine& X) {
    const Json* primitives = mesh == nullptr ? nullptr : member(*mesh, "primitives");
    if (primitives == nullptr || !primitives->is_array()) {
      return data_.fail_broken("a mesh has no primitives");
    }
    for (const Json& written : *primitives) {
      if (++steps_ > kMostSteps) return data_.fail_unread("repeats too many parts to be read");
      const Json* mode = member(written, "mode");
      const auto kind = mode == nullptr ? std::optional(kTriangles) : natural(mode);
      if (!kind || *kind > kFan) return data_.fail_broken("a primitive has an unknown mode");
      if (*kind < kTriangles) continue;  // points and lines
      const auto primitive = read(written, *kind);
      if (!primitive) return false;
      triangles_.set_color(color_of(member(written, "material")));
      if (!add(*primitive, X)) return false;
    }
    return true;
  }

  std::optional<Primitive> read(const Json& written, std::uint64_t mode) {
    const Json* attributes = member(written, "attributes");
    const Json* position = attributes == nullptr ? nullptr : member(*attributes, "POSITION");
    if (position == nullptr) {
      data_.fail_broken("a primitive has no points");
      return std::nullopt;
    }
    const auto points = data_.accessor(position, "VEC3");
    if (!points) return std::nullopt;
    if (points->type != kFloat) {
      data_.fail_broken("the points of a primitive are no floats");
      return std::nullopt;
    }
    const Json* written_indices = member(written, "indices");
    if (written_indices == nullptr) return Primitive{*points, std::nullopt, points->count, mode};
    const auto indices = data_.accessor(written_indices, "SCALAR");
    if (!indices) return std::nullopt;
    if (indices->type == kFloat) {
      data_.fail_broken("the indices of a primitive are no integers");
      return std::nullopt;
    }
    return Primitive{*points, indices, indices->count, mode};
  }

  bool add(const Primitive& primitive, const Affine& X) {
    const std::uint64_t step = primitive.mode == kTriangles ? 3 : 1;
    if (primitive.mode == kTriangles && primitive.count % 3 != 0) {
      return data_.fail_broken("a primitive ends inside a triangle");
    }
    for (std::uint64_t i = 0; i + 3 <= primitive.count; i += step) {
      const bool is_turned = primitive.mode == kStrip && i % 2 == 1;
      const std::uint64_t corners[] = {primitive.mode == kFan ? 0
                                       : is_turned            ? i + 1
                                                              : i,
                                       is_turned ? i : i + 1, i + 2};
      Vector3 points[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t place =
            primitive.indices ? primitive.indices->index(corners[k]) : corners[k];
        if (place >= primitive.points.count) {
          return data_.fail_broken("the index " + std::to_string(place) + " names none of " +
                                   std::to_string(primitive.points.count) + " points");
        }
        const Vector3 point = primitive.points.point(place);
        if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2])) {
          return data_.fail_broken("the coordinates of a point are not all numbers");
        }
        points[k] = X * point;
      }
      if (!triangles_.add(points[0], points[1], points[2])) return false;
    }
    return true;
  }

  /// None for a texture.
  std::optional<Rgba> color_of(const Json* index) {
    if (index == nullptr) return std::nullopt;
    const Json* material = data_.item("materials", index);
    const Json* pbr = material == nullptr ? nullptr : member(*material, "pbrMetallicRoughness");
    if (pbr == nullptr || member(*pbr, "baseColorTexture") != nullptr) return std::nullopt;
    Rgba color;
    if (!read_numbers(member(*pbr, "baseColorFactor"), color)) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) color[i] = screen_value(color[i]);
    const bool is_blended = is_text(member(*material, "alphaMode"), "BLEND");
    color[3] = is_blended ? std::fmin(std::fmax(color[3], 0), 1) : 1;
    return color;
  }

  /// Nodes may name a mesh any number of times.
  static constexpr std::size_t kMostSteps = 4'000'000;

  Data& data_;
  TriangleCollector& triangles_;
  std::vector<bool> is_placed_;
  std::vector<Placed> left_;
  std::size_t steps_ = 0;
};

}  // namespace

std::string read_gltf_triangles(std::string_view bytes, const MeshNeighbours& neighbours,
                                TriangleCollector& triangles) {
  Data data(bytes, neighbours);
  if (data.reason().empty()) GltfTriangles(data, triangles).read();
  return data.reason();
}

}  // namespace smurf
