// SPDX-License-Identifier: BSD-3-Clause
// Every solid of an instance where it stands, for writers of pictures.
#pragma once

#include <optional>
#include <vector>

#include "link/scene_link.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

/// A URDF shape as a flat one; none when it is incomplete.
std::optional<FlatGeometry> to_flat(const urdf::Geometry& geometry, const FlatModel& model);

/// Colour of a visual: its own, or that of the robot's material of the same name.
std::optional<Rgba> color_of(const urdf::Visual& visual, const urdf::Robot& robot);

struct PlacedShape {
  Pose X_WS;
  FlatGeometry geometry;
  std::optional<Rgba> color;
};

/// Of a link the visuals, or the collisions when it has none. `frames` keeps what was computed from
/// call to call.
std::vector<PlacedShape> placed_shapes(const SceneExport& scene, std::size_t instance,
                                       LinkFrames& frames);

}  // namespace smurf
