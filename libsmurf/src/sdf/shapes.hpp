// SPDX-License-Identifier: BSD-3-Clause
// Shapes of links, and how they are written as visuals and collisions of a URDF.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>

#include "sdf/model.hpp"

namespace smurf::sdformat {

struct Shape {
  enum class Kind : std::uint8_t {
    none,
    box,
    sphere,
    cylinder,
    capsule,
    ellipsoid,
    cone,
    plane,
    mesh,
    polyline,
    heightmap,
    image
  };
  Kind kind = Kind::none;
  View element;                  ///< `<box>` and so on
  std::array<double, 3> size{};  ///< sides; radius and length; radii; scale of a mesh, metres
  Vector3 normal{0, 0, 1};       ///< of a plane
};

/// That of a visual or a collision.
Shape read_shape(View owner);
/// In the frame of the link.
Pose pose_of_shape(View owner, const Link& link, Frames& frames);

/// Whether heightmaps of a link become entities of a scene.
bool becomes_ground(const Model& model, const Link& link);

class ShapeWriter {
 public:
  ShapeWriter(Model& model, Files& files, Reporter& reporter, TracedXml& xml)
      : model_(model), files_(files), reporter_(reporter), xml_(xml), frames_(reporter) {}

  void write(const Link& link);

 private:
  struct Colour {
    std::string name;
    std::array<double, 4> rgba{};
    Place place;
  };
  void one(const Link& link, View element);
  bool has_geometry(const Shape& shape);
  void geometry(const Shape& shape, const Link& link);
  std::optional<Colour> colour(View visual, xacro::FrameId frame);
  void material(View visual, xacro::FrameId frame);

  Model& model_;
  Files& files_;
  Reporter& reporter_;
  TracedXml& xml_;
  Frames frames_;
};

}  // namespace smurf::sdformat
