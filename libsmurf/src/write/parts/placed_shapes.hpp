// SPDX-License-Identifier: BSD-3-Clause
// All solids of an instance, for formats that show scenes without simulating them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link/scene_link.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

/// A URDF shape in flat form; none if it is incomplete.
std::optional<FlatGeometry> to_flat(const urdf::Geometry& geometry, const FlatModel& model);

/// Colour of a visual in the URDF: its own, or that of the robot's material of the same name.
std::optional<Rgba> color_of(const urdf::Visual& visual, const LinkedModel& model);

/// The texture of a visual as written, found in the same way; null if there is none.
const std::string* written_texture(const urdf::Visual& visual, const LinkedModel& model);
/// The texture of a visual as a path relative to the output's folder; null if there is none.
std::optional<std::string> texture_of(const urdf::Visual& visual, const LinkedModel& model,
                                      const FlatModel& flat);

/// Whether MuJoCo can read the file, which must be a PNG.
bool is_texture_of_mujoco(const MeshReference& reference);

/// Converts a colour from sRGB, as in URDF and SMURF, to linear amounts of light, as in glTF and
/// USD. Within 0..1; alpha is unchanged.
Rgba linear_color(const Rgba& color);

class AnnotatedColors;

/// Poses X_EL of the links of an instance; empty if it has no model. Valid until the next call.
const std::vector<std::optional<Pose>>& frames_of(const SceneExport& scene, std::size_t instance,
                                                  LinkFrames& frames);

struct LinkShape {
  Pose X_LS;
  FlatGeometry geometry;
  std::optional<Rgba> color;
  Span span;  ///< where it is written
};
struct ShownLink {
  std::string name;  ///< empty for an entity without a model
  Pose X_EL;
  std::vector<LinkShape> shapes;  ///< the visuals, or the collisions if there are no visuals
};
/// The links that the root of an instance's model reaches. An entity without a model is treated as
/// one link. `frames` caches results between calls.
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
