// SPDX-License-Identifier: BSD-3-Clause
// The meshes of glTF 2.0, placed by the nodes of its scene. The y axis of glTF is up. It is turned
// to z, as RViz (ros2/rviz pull request 1482), Drake and Meshcat turn it; Gazebo does not.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "mesh/affine.hpp"
#include "mesh/gltf_data.hpp"

namespace smurf::gltf {

inline constexpr std::uint64_t kTriangles = 4;
inline constexpr std::uint64_t kStrip = 5;
inline constexpr std::uint64_t kFan = 6;

/// Triangles of one material.
struct Primitive {
  Accessor points;
  std::optional<Accessor> indices;
  std::uint64_t count, mode;
  const Json* written;

  std::uint64_t triangles() const {
    return mode == kTriangles ? count / 3 : count < 3 ? 0 : count - 2;
  }
};

/// The index of the point at a corner.
inline std::uint64_t place_of(const Primitive& primitive, std::uint64_t corner) {
  return primitive.indices ? primitive.indices->index(corner) : corner;
}
/// The point of this index, before any transform. On failure, returns none and sets the reason in
/// `data`.
std::optional<Vector3> point_at(Data& data, const Primitive& primitive, std::uint64_t place);

/// A triangle of a primitive.
struct Corners {
  Vector3 points[3];        ///< transformed
  std::uint64_t places[3];  ///< of the corners in the primitive
};
/// Receives a triangle. Returns false to stop.
using CornersVisitor = std::function<bool(const Corners& triangle)>;
/// Visits the triangles of a primitive, moved by `X`. False if a visit was, or on failure, which
/// sets the reason in `data`.
bool visit_triangles(Data& data, const Primitive& primitive, const Affine& X,
                     const CornersVisitor& visit);

/// The reason for files with too many repeated parts.
inline constexpr const char* kRepeats = "repeats too many parts to be read";

/// Receives a mesh, its number and its transform. Returns false to stop.
using MeshVisitor = std::function<bool(const Json& mesh, std::uint64_t number, const Affine& X)>;
/// Visits each mesh of the scene once for each node that places it. On failure, sets the reason in
/// `data`.
void visit_meshes(Data& data, const MeshVisitor& visit);

/// Receives a part of a mesh. Returns false to stop.
using PrimitiveVisitor = std::function<bool(const Primitive& primitive)>;
/// Visits each part of a mesh that has triangles. `steps` counts the parts of all meshes, which
/// nodes may name any number of times. On failure, returns false and sets the reason in `data`.
bool visit_primitives(Data& data, const Json& mesh, std::size_t& steps,
                      const PrimitiveVisitor& visit);

}  // namespace smurf::gltf
