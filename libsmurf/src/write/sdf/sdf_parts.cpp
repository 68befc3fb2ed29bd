// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf/sdf_parts.hpp"

#include <algorithm>
#include <bit>
#include <numbers>

#include "base/numbers/numbers.hpp"
#include "write/parts/height_range.hpp"

namespace smurf {
namespace {

std::string rgba_text(const Rgba& color) {
  return join_numbers({color[0], color[1], color[2], color[3]});
}

class GeometryWriter {
 public:
  explicit GeometryWriter(XmlText& xml) : xml_(xml) {}

  void operator()(const FlatPlane& plane) const {
    xml_.open("plane");
    xml_.leaf("normal", "0 0 1");
    xml_.leaf("size", join_numbers({plane.length, plane.width}));
    xml_.close();
  }
  void operator()(const FlatBox& box) const {
    xml_.open("box");
    xml_.leaf("size", join_numbers(box.size));
    xml_.close();
  }
  void operator()(const FlatSphere& sphere) const {
    xml_.open("sphere");
    xml_.leaf("radius", sphere.radius);
    xml_.close();
  }
  void operator()(const FlatCylinder& cylinder) const {
    add_round("cylinder", cylinder.radius, cylinder.length);
  }
  void operator()(const FlatCapsule& capsule) const {
    add_round("capsule", capsule.radius, capsule.length);
  }
  void operator()(const FlatMesh& mesh) const {
    xml_.open("mesh");
    xml_.leaf("uri", mesh.file);
    if (mesh.scale != Vector3{1, 1, 1}) xml_.leaf("scale", join_numbers(mesh.scale));
    xml_.close();
  }
  void operator()(const FlatHeightmap& map) const {
    xml_.open("heightmap");
    xml_.leaf("uri", map.file);
    xml_.leaf("size", join_numbers({map.length, map.width, map.height}));
    xml_.close();
  }

 private:
  void add_round(std::string_view name, double radius, double length) const {
    xml_.open(name);
    xml_.leaf("radius", radius);
    xml_.leaf("length", length);
    xml_.close();
  }

  XmlText& xml_;
};

}  // namespace

void add_sdf_pose(XmlText& xml, const Pose& pose, bool is_old) {
  const Quaternion& q = pose.orientation;
  if (pose == Pose{}) return;
  if (is_old) {
    xml.leaf("pose", join_numbers(pose.position) + " " + join_numbers(to_rpy(q)));
  } else {
    xml.leaf("pose", join_numbers(pose.position) + " " + join_numbers({q.x, q.y, q.z, q.w}),
             {{"rotation_format", "quat_xyzw"}});
  }
}

void add_sdf_inertial(XmlText& xml, const LinkInertial& mass, bool is_old) {
  xml.open("inertial");
  add_sdf_pose(xml, mass.X_LC, is_old);
  xml.leaf("mass", mass.mass);
  xml.open("inertia");
  xml.leaf("ixx", mass.ixx);
  xml.leaf("ixy", mass.ixy);
  xml.leaf("ixz", mass.ixz);
  xml.leaf("iyy", mass.iyy);
  xml.leaf("iyz", mass.iyz);
  xml.leaf("izz", mass.izz);
  xml.close();
  xml.close();
}

void add_sdf_geometry(XmlText& xml, const FlatGeometry& geometry) {
  xml.open("geometry");
  std::visit(GeometryWriter(xml), geometry);
  xml.close();
}

void add_sdf_light(XmlText& xml, const Light& light, const std::string& name, bool is_old) {
  const bool is_directional = light.directional.value_or(false);
  const bool is_spot = !is_directional && light.type.value_or(1) == 2;
  const std::string type = is_directional ? "directional" : is_spot ? "spot" : "point";
  xml.open("light", {{"name", name}, {"type", type}});
  add_sdf_pose(xml, {light.position.value_or({0, 0, 0}), {}}, is_old);
  xml.leaf("diffuse", rgba_text(color_or(light.diffuse, {1, 1, 1, 1})));
  xml.leaf("specular", rgba_text(color_or(light.specular, {0.2, 0.2, 0.2, 1})));
  xml.open("attenuation");
  xml.leaf("range", 1000);
  xml.leaf("constant", light.constant_attenuation.value_or(1));
  xml.leaf("linear", light.linear_attenuation.value_or(0));
  xml.leaf("quadratic", light.quadratic_attenuation.value_or(0));
  xml.close();
  xml.leaf("direction", join_numbers(direction_of(light)));
  if (is_spot) {
    const double angle = light.angle.value_or(90) * std::numbers::pi / 180;
    xml.open("spot");
    xml.leaf("inner_angle", angle / 2);
    xml.leaf("outer_angle", angle);
    xml.leaf("falloff", light.exponent.value_or(0));
    xml.close();
  }
  xml.close();
}

Rgba as_libsdformat_has(const Rgba& color) {
  constexpr double kLight = 0.8;
  const auto brighter = [](double value) { return std::clamp(value / kLight, 0.0, 1.0); };
  return {brighter(color[0]), brighter(color[1]), brighter(color[2]), color[3]};
}

void add_sdf_material(XmlText& xml, const SdfMaterial& material) {
  if (!material.color && !material.texture && material.script.empty()) return;
  xml.open("material");
  if (!material.script.empty()) {
    xml.open("script");
    xml.leaf("name", material.script);
    xml.leaf("uri", "file://media/materials/scripts/gazebo.material");
    xml.close();
  }
  if (material.color) {
    xml.leaf("ambient", rgba_text(*material.color));
    xml.leaf("diffuse", rgba_text(*material.color));
  }
  if (material.texture) {
    xml.open("pbr");
    xml.open("metal");
    xml.leaf("albedo_map", *material.texture);
    xml.close();
    xml.close();
  }
  xml.close();
}

void add_sdf_surface(XmlText& xml, const Contacts& contacts, const GazeboElements* gazebo,
                     std::string_view link) {
  const bool has_contact = gazebo != nullptr && gazebo->has_contact(link);
  const bool has_friction = gazebo != nullptr && gazebo->has_friction(link);
  const bool is_slippery = contacts.friction1 || contacts.friction2;
  if (!has_contact && !has_friction && !contacts.bitmask && !is_slippery) return;
  xml.open("surface");
  if (contacts.bitmask || has_contact) {
    xml.open("contact");
    if (contacts.bitmask) xml.leaf("collide_bitmask", std::to_string(*contacts.bitmask));
    if (has_contact) gazebo->add_contact(xml, link);
    xml.close();
  }
  if (has_friction || is_slippery) {
    xml.open("friction");
    xml.open("ode");
    if (has_friction) gazebo->add_friction(xml, link);
    if (!has_friction && contacts.friction1) xml.leaf("mu", *contacts.friction1);
    if (!has_friction && contacts.friction2) xml.leaf("mu2", *contacts.friction2);
    xml.close();
    xml.close();
  }
  xml.close();
}

/// "Heightmap image size must be square, with a size of 2^n+1" (gazebo-classic Heightmap.cc), and
/// the world does not load.
bool is_heightmap_of_gazebo(const MeshSource& files, const FlatHeightmap& map) {
  const FileContent image = files.image ? files.image(map.file) : FileContent{};
  if (!files.image || image.status != ReadStatus::ok) return true;
  const HeightRange range = height_range(image.text, files.most_pixels);
  return !range.fault.empty() ||
         (range.width == range.height && range.width > 1 && std::has_single_bit(range.width - 1));
}

}  // namespace smurf
