// SPDX-License-Identifier: BSD-3-Clause
// All solids of an instance, for formats that show scenes without simulating them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link/scene_link.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

/// A URDF shape as a flat one; none when it is incomplete.
std::optional<FlatGeometry> to_flat(const urdf::Geometry& geometry, const FlatModel& model);

/// Colour of a visual in the URDF: its own, or that of the robot's material of the same name.
std::optional<Rgba> color_of(const urdf::Visual& visual, const LinkedModel& model);

/// The texture of a visual, likewise, as it is written; null without.
const std::string* written_texture(const urdf::Visual& visual, const LinkedModel& model);
/// The texture of a visual as a path relative to the output's folder; null when it has none.
std::optional<std::string> texture_of(const urdf::Visual& visual, const LinkedModel& model,
                                      const FlatModel& flat);

/// MuJoCo reads PNG files.
bool is_texture_of_mujoco(const MeshReference& reference);

/// A colour in glTF and USD: amounts of light, where URDF and SMURF have values for a screen
/// (sRGB). Within 0..1; the alpha stays.
Rgba linear_color(const Rgba& color);

class AnnotatedColors;

struct LinkShape {
  Pose X_LS;
  FlatGeometry geometry;
  std::optional<Rgba> color;
  Span span;  ///< where it is written
};
struct ShownLink {
  std::string name;  ///< empty for an entity that is no model
  Pose X_EL;
  std::vector<LinkShape> shapes;  ///< the visuals, or the collisions when there are none
};
/// The links that the root of an instance's model reaches. An entity that is no model counts as one
/// link. `frames` keeps what was computed from call to call.
std::vector<ShownLink> shown_links(const SceneExport& scene, std::size_t instance,
                                   LinkFrames& frames, AnnotatedColors& colors);

struct PlacedShape {
  Pose X_WS;
  FlatGeometry geometry;
  std::optional<Rgba> color;
};
/// The shapes of all links in the world.
std::vector<PlacedShape> placed_shapes(const SceneExport& scene, std::size_t instance,
                                       LinkFrames& frames, AnnotatedColors& colors);

}  // namespace smurf
