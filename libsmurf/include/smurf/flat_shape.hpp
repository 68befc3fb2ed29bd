// SPDX-License-Identifier: BSD-3-Clause
// Solid shapes of a flat scene. They come from a URDF, an entity or an old scene.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "smurf/pose.hpp"

namespace smurf {

/// A rectangle in the xy plane around the origin; its normal is z.
struct FlatPlane {
  double length = 0;  ///< along x, m
  double width = 0;   ///< along y, m
};
/// Centred on its origin.
struct FlatBox {
  Vector3 size{};  ///< full edge lengths, m
};
/// Centred on its origin.
struct FlatSphere {
  double radius = 0;  ///< m
};
/// Centred on its origin, along z.
struct FlatCylinder {
  double radius = 0;  ///< m
  double length = 0;  ///< m, along z
};
/// A cylinder with two hemispheres, centred on its origin, along z.
struct FlatCapsule {
  double radius = 0;  ///< m
  double length = 0;  ///< m, of the cylindrical part
};
/// A mesh file, scaled about its origin.
struct FlatMesh {
  std::string file;  ///< relative to the output's folder
  Vector3 scale{1, 1, 1};
};
/// Grey values of an image as heights, around the origin.
struct FlatHeightmap {
  std::string file;   ///< relative to the output's folder
  double length = 0;  ///< along x, m
  double width = 0;   ///< along y, m
  double height = 0;  ///< of the brightest value, m
};
using FlatGeometry = std::variant<FlatPlane, FlatBox, FlatSphere, FlatCylinder, FlatCapsule,
                                  FlatMesh, FlatHeightmap>;

using Rgba = std::array<double, 4>;  ///< 0..1

/// One solid of an entity.
struct FlatShape {
  std::string name;  ///< may be empty
  Pose X_ES;         ///< in the frame of the entity
  FlatGeometry geometry;
  std::optional<Rgba> color;
};

}  // namespace smurf
