// SPDX-License-Identifier: BSD-3-Clause
// SDF elements that occur in several places.
#pragma once

#include <optional>
#include <string>

#include "write/parts/contacts.hpp"
#include "write/parts/gazebo_elements.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/text/xml_text.hpp"

namespace smurf {

/// Writes nothing for the identity. SDF 1.6 supports only roll, pitch, yaw.
void add_sdf_pose(XmlText& xml, const Pose& pose, bool is_old);
void add_sdf_inertial(XmlText& xml, const LinkInertial& mass, bool is_old);
/// <geometry>
void add_sdf_geometry(XmlText& xml, const FlatGeometry& geometry);
void add_sdf_light(XmlText& xml, const Light& light, const std::string& name, bool is_old);

struct SdfMaterial {
  std::optional<Rgba> color;
  std::optional<std::string> texture;  ///< a file
  std::string_view script;             ///< of Gazebo Classic: "Gazebo/Red"
};
/// The colour in Gazebo for a colour of a URDF. Gazebo's light is darker than that of RViz, so
/// libsdformat converts it (parser_urdf.cc, CreateVisual).
Rgba as_libsdformat_has(const Rgba& color);
void add_sdf_material(XmlText& xml, const SdfMaterial& material);

/// <surface>, if it has contents. `gazebo` may be null; otherwise it has settings for `link`.
void add_sdf_surface(XmlText& xml, const Contacts& contacts, const GazeboElements* gazebo,
                     std::string_view link);

/// False if Gazebo refuses the size of an image. True for a file that cannot be read here.
bool is_heightmap_of_gazebo(const MeshSource& files, const FlatHeightmap& map);

}  // namespace smurf
