// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/floating.hpp"
#include "base/little_endian.hpp"
#include "base/numbers.hpp"
#include "base/path.hpp"
#include "base/quoted.hpp"
#include "base/vectors.hpp"
#include "link/mujoco_compiler.hpp"
#include "write/body_inertia.hpp"

namespace smurf {
namespace {

using Geom = std::pair<std::string, std::string>;

/// A geom with these sizes; none if a size is not positive, because MuJoCo refuses it.
std::optional<Geom> sized(const char* type, std::initializer_list<double> sizes) {
  if (std::any_of(sizes.begin(), sizes.end(), [](double size) { return !(size > 0); })) {
    return std::nullopt;
  }
  return Geom{type, join_numbers(sizes)};
}

/// Type and size of a geom; none for meshes and for shapes that MuJoCo does not have.
std::optional<Geom> solid_geom(const FlatGeometry& geometry) {
  if (const auto* box = std::get_if<FlatBox>(&geometry)) {
    return sized("box", {box->size[0] / 2, box->size[1] / 2, box->size[2] / 2});
  }
  if (const auto* sphere = std::get_if<FlatSphere>(&geometry)) {
    return sized("sphere", {sphere->radius});
  }
  if (const auto* cylinder = std::get_if<FlatCylinder>(&geometry)) {
    return sized("cylinder", {cylinder->radius, cylinder->length / 2});
  }
  if (const auto* capsule = std::get_if<FlatCapsule>(&geometry)) {
    return sized("capsule", {capsule->radius, capsule->length / 2});
  }
  if (const auto* plane = std::get_if<FlatPlane>(&geometry)) {
    return sized("plane", {plane->length / 2, plane->width / 2, 1});
  }
  return std::nullopt;
}

constexpr const char* kAllBits = "65535";  // of MARS

/// The fewest bytes of three numbers and of an index.
constexpr PreviewMeshes::Cost kCost{6, 2};

bool is_mesh_of_mujoco(const FlatMesh& mesh) {
  const std::string extension = path::to_lower(path::extension(mesh.file));
  return extension == ".stl" || extension == ".obj";
}

/// MuJoCo reads only binary STL without other bytes after the triangles.
bool is_stl_of_mujoco(std::string_view bytes) {
  constexpr std::size_t kCountAt = 80;
  constexpr std::size_t kHeader = 84;
  constexpr std::size_t kTriangle = 50;
  if (bytes.size() < kHeader) return false;
  const std::size_t triangles = read_uint32(bytes, kCountAt);
  return triangles <= kMostStlTrianglesOfMujoco && bytes.size() == kHeader + kTriangle * triangles;
}

using Point = std::array<float, 3>;

Vector3 between(const Point& a, const Point& b) {
  return difference({b[0], b[1], b[2]}, {a[0], a[1], a[2]});
}

/// All points are in one plane, so they enclose no volume.
bool is_flat(const std::vector<Point>& points) {
  constexpr double kThin = 1e-12;  // of a square of lengths
  Vector3 along{};
  Vector3 normal{};
  for (const Point& point : points) {
    const Vector3 to = between(points.front(), point);
    if (dot(to, to) > dot(along, along)) along = to;
  }
  for (const Point& point : points) {
    const Vector3 area = cross(along, between(points.front(), point));
    if (dot(area, area) > dot(normal, normal)) normal = area;
  }
  const double least = kThin * dot(normal, normal) * dot(along, along);
  return std::all_of(points.begin(), points.end(), [&](const Point& point) {
    const double height = dot(normal, between(points.front(), point));
    return height * height <= least;
  });
}

/// The volume as MuJoCo computes it: of the tetrahedra between the triangles and the centre of the
/// surface, whatever the side that a triangle faces.
double volume_of(const MeshTriangles& mesh) {
  const auto point = [&](std::size_t at) -> Vector3 {
    const Point& p = mesh.points[mesh.indices[at]];
    return {p[0], p[1], p[2]};
  };
  Vector3 center{};
  double total_area = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vector3 normal =
        cross(difference(point(i + 1), point(i)), difference(point(i + 2), point(i)));
    const double area = std::sqrt(dot(normal, normal));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      center[axis] += area * (point(i)[axis] + point(i + 1)[axis] + point(i + 2)[axis]) / 3;
    }
    total_area += area;
  }
  if (!(total_area > 0)) return 0;
  for (double& coordinate : center) coordinate /= total_area;
  double volume = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vector3 normal =
        cross(difference(point(i + 1), point(i)), difference(point(i + 2), point(i)));
    volume += std::abs(dot(normal, difference(point(i), center))) / 6;
  }
  return volume;
}

}  // namespace

std::string quaternion_text(const Quaternion& q) { return join_numbers({q.w, q.x, q.y, q.z}); }

MjcfParts::MjcfParts(const SceneExport& scene)
    : scene_(scene), losses_(scene, SceneColumn::mjcf, "MJCF"), files_(scene, kCost) {
  for (const LinkedModel& model : scene.scene.models) {
    for (const CollisionAnnotation& entry : model.annotations.collisions) {
      if (entry.bitmask) has_bitmasks_ = true;
    }
  }
  for (const FlatInstance& instance : scene.flat.instances) {
    if (!instance.shapes.empty() && contacts_of(instance.properties).bitmask) has_bitmasks_ = true;
  }
}

void MjcfParts::add_settings() {
  // Bodies without mass have none in the result: the mass of a model must not be guessed from its
  // shapes.
  xml_.empty("compiler", {{"angle", "radian"},
                          {"boundmass", "0"},
                          {"balanceinertia", "false"},
                          {"inertiafromgeom", "false"}});
  const FlatPhysics& physics = scene_.flat.physics;
  // Uses an integrator in which dampers and motors with velocity gains are stable at any stiffness.
  xml_.empty("option", {{"timestep", format_number(physics.step_size.value_or(kUsualStep))},
                        {"gravity", join_numbers(physics.gravity.value_or(kUsualGravity))},
                        {"integrator", "implicit"}});
  xml_.open("default");
  add_class("visual", {{"contype", "0"}, {"conaffinity", "0"}, {"group", "2"}});
  // Shapes without a bitmask collide with all that have one, as in MARS.
  const XmlText::Attribute type{"contype", has_bitmasks_ ? kAllBits : "1"};
  const XmlText::Attribute affinity{"conaffinity", has_bitmasks_ ? kAllBits : "1"};
  // Viewers show the groups 0 to 2. Shapes without a separate visual are in group 0.
  add_class("collision", {type, affinity, {"group", "3"}});
  add_class("solid", {type, affinity, {"group", "0"}});
  xml_.close();
}

void MjcfParts::add_class(const std::string& name, const std::vector<XmlText::Attribute>& geom) {
  xml_.open("default", {{"class", name}});
  xml_.empty("geom", geom);
  xml_.close();
}

void MjcfParts::add_inertial(const LinkInertial& mass, bool moves, Span span,
                             const std::string& name) {
  // MuJoCo refuses a full tensor with an eigenvalue below mjEPS, and a moving body with a mass or
  // moment below mjMINVAL.
  constexpr double kEpsilon = 1e-14;
  const BodyInertia body = body_inertia(mass, moves ? kEpsilon : 0, 2 * kEpsilon);
  if (body.is_changed) losses_.note(kRefusedInertias, span, name);
  const LinkInertial& given = body.mass;
  std::vector<XmlText::Attribute> attributes{{"pos", join_numbers(given.X_LC.position)},
                                             {"mass", format_number(given.mass)}};
  if (body.is_principal) {
    attributes.emplace_back("diaginertia", join_numbers({given.ixx, given.iyy, given.izz}));
    attributes.emplace_back("quat", quaternion_text(given.X_LC.orientation));
  } else {
    // MuJoCo does not accept an orientation together with a full tensor.
    const std::array<double, 6> I = tensor_in_link(given);
    attributes.emplace_back("fullinertia", join_numbers({I[0], I[1], I[2], I[3], I[4], I[5]}));
  }
  xml_.empty("inertial", attributes);
}

void MjcfParts::add_geom(std::vector<XmlText::Attribute> geom, const Pose& pose,
                         const std::optional<Rgba>& color, const Contacts& contacts) {
  const Rgba c = color.value_or(Rgba{0.5, 0.5, 0.5, 1});
  geom.emplace_back("pos", join_numbers(pose.position));
  geom.emplace_back("quat", quaternion_text(pose.orientation));
  geom.emplace_back("rgba", join_numbers({c[0], c[1], c[2], c[3]}));
  if (contacts.bitmask) {
    // MuJoCo has 32 bits with a sign, MARS 16.
    const std::string bits = std::to_string(*contacts.bitmask & 0x7fffffff);
    geom.emplace_back("contype", bits);
    geom.emplace_back("conaffinity", bits);
  }
  if (contacts.friction1) {
    // Only sliding friction has a value; torsional and rolling friction keep the defaults of
    // MuJoCo.
    geom.emplace_back("friction", join_numbers({*contacts.friction1, 0.005, 0.0001}));
  }
  xml_.empty("geom", geom);
}

/// Meshes of old scenes.
void MjcfParts::add_meshes_of_entities() {
  for (std::size_t i = 0; i < count(); ++i) {
    for (const FlatShape& shape : flat(i).shapes) {
      const auto* mesh = std::get_if<FlatMesh>(&shape.geometry);
      if (mesh == nullptr || !flat(i).X_WE || meshes_.contains(mesh_key(*mesh))) continue;
      const Span place = place_of(scene_.scene.entity(linked(i)));
      const std::string reason =
          scene_.meshes.triangles ? declare_mesh(*mesh, place) : "is not available";
      if (!reason.empty()) losses_.unseen_shape(place, shape.geometry, reason);
    }
  }
}

void MjcfParts::add_heightmaps() {
  for (std::size_t i = 0; i < count(); ++i) {
    for (const FlatShape& shape : flat(i).shapes) {
      const auto* map = std::get_if<FlatHeightmap>(&shape.geometry);
      if (map == nullptr || !flat(i).X_WE) continue;
      const std::string_view fault = fault_of_heightmap(map->file);
      if (!fault.empty()) {
        const std::string which = "heightmap " + quoted(map->file);
        if (flat(i).shapes.size() == 1) {
          losses_.entity(i, "its " + which + " " + std::string(fault));
        } else {
          losses_.shape(place_of(scene_.scene.entity(linked(i))),
                        "the " + which + ", which " + std::string(fault) + ",");
        }
        continue;
      }
      // An old scene may have several heightmaps.
      const std::size_t index = static_cast<std::size_t>(&shape - flat(i).shapes.data());
      const std::string own_name =
          index == 0 ? flat(i).path : name(i, "heights_" + std::to_string(index));
      heightmaps_.emplace(&shape, own_name);
      xml_.empty("hfield", {{"name", own_name},
                            {"file", map->file},
                            {"size", join_numbers({map->length / 2, map->width / 2, map->height,
                                                   map->height / 10 + 0.01})}});
    }
  }
}

void MjcfParts::add_lights() {
  for (const Light* light : world_lights(scene_)) {
    const Rgba white{1, 1, 1, 1};
    const auto rgb = [](const Rgba& color) { return join_numbers({color[0], color[1], color[2]}); };
    const bool is_spot = light->type.value_or(1) == 2;
    xml_.empty("light", {{"pos", join_numbers(light->position.value_or({0, 0, 0}))},
                         {"dir", join_numbers(direction_of(*light))},
                         {"directional", light->directional.value_or(false) ? "true" : "false"},
                         {"attenuation", join_numbers({light->constant_attenuation.value_or(1),
                                                       light->linear_attenuation.value_or(0),
                                                       light->quadratic_attenuation.value_or(0)})},
                         {"cutoff", format_number(is_spot ? light->angle.value_or(90) : 180)},
                         {"exponent", format_number(light->exponent.value_or(0))},
                         {"ambient", rgb(color_or(light->ambient, {0, 0, 0, 1}))},
                         {"diffuse", rgb(color_or(light->diffuse, white))},
                         {"specular", rgb(color_or(light->specular, {0.3, 0.3, 0.3, 1}))}});
  }
}

std::optional<std::vector<XmlText::Attribute>>
MjcfParts::geom_of(const std::string& geom_class, const FlatGeometry& geometry) const {
  if (const auto* mesh = std::get_if<FlatMesh>(&geometry)) {
    const auto known = meshes_.find(mesh_key(*mesh));
    if (known == meshes_.end()) return std::nullopt;
    return {{{"class", geom_class}, {"type", "mesh"}, {"mesh", known->second}}};
  }
  const auto geom = solid_geom(geometry);
  if (!geom) return std::nullopt;
  return {{{"class", geom_class}, {"type", geom->first}, {"size", geom->second}}};
}

std::string MjcfParts::mesh_key(const FlatMesh& mesh) {
  return mesh.file + " " + join_numbers(mesh.scale);
}

std::string MjcfParts::declare_mesh(const FlatMesh& mesh, Span place) {
  const std::string& file = files_.first_name(mesh.file);
  const auto [known, is_new] = mesh_files_.try_emplace(file);
  MeshOfFile& of_file = known->second;
  if (!of_file.reason.empty()) return of_file.reason;
  if (is_new) examine(mesh, of_file);
  MeshTriangles triangles;
  if (!of_file.is_named) {
    triangles = files_.read(file, place);
  } else if (is_new && of_file.is_readable) {
    triangles = scene_.meshes.triangles(file, TexturePoints::ignored);
  }
  if (triangles.reason.empty() && !triangles.points.empty() && is_new) {
    if (is_flat(triangles.points)) triangles.reason = "is flat, which MuJoCo refuses";
    of_file.volume = volume_of(triangles);
  }
  if (!triangles.reason.empty()) return of_file.reason = triangles.reason;
  // MuJoCo refuses a volume below mjMINVAL.
  constexpr double kLeastVolume = 1e-14;
  const Vector3& scale = mesh.scale;
  if (of_file.volume &&
      !(*of_file.volume * std::abs(scale[0] * scale[1] * scale[2]) > kLeastVolume)) {
    return "has too little volume for MuJoCo";
  }
  const std::string mesh_name = "mesh_" + std::to_string(meshes_.size());
  if (of_file.is_named) {
    xml_.empty("mesh", {{"name", mesh_name}, {"file", mesh.file}, {"scale", join_numbers(scale)}});
  } else {
    declare_triangles(mesh_name, mesh, triangles);
  }
  meshes_.emplace(mesh_key(mesh), mesh_name);
  return {};
}

/// Decided by the extension, and of STL also by the content. A file that may not be read here, such
/// as one outside of the project, may be sound.
void MjcfParts::examine(const FlatMesh& mesh, MeshOfFile& of_file) const {
  of_file.is_named = is_mesh_of_mujoco(mesh);
  if (!of_file.is_named || !scene_.meshes.image || !scene_.meshes.triangles) return;
  const FileContent content = scene_.meshes.image(mesh.file);
  of_file.is_readable = content.status == ReadStatus::ok || content.status == ReadStatus::not_found;
  if (content.status != ReadStatus::ok) return;
  const bool is_stl = path::to_lower(path::extension(mesh.file)) == ".stl";
  of_file.is_named = !is_stl || is_stl_of_mujoco(content.text);
}

std::string_view MjcfParts::fault_of_heightmap(const std::string& file) const {
  const bool is_named_so = path::to_lower(path::extension(file)) == ".png";
  if (is_named_so && is_png(file)) return {};
  const bool is_missing =
      scene_.meshes.image && scene_.meshes.image(file).status == ReadStatus::not_found;
  return is_missing ? "does not exist" : "is no PNG file, the only ones that MuJoCo reads";
}

bool MjcfParts::is_png(const std::string& file) const {
  if (!scene_.meshes.image) return true;
  const FileContent content = scene_.meshes.image(file);
  if (content.status != ReadStatus::ok) return content.status != ReadStatus::not_found;
  // The last part is missing in a file that was cut off.
  return content.text.starts_with("\x89PNG\r\n\x1a\n") &&
         content.text.find("IEND") != std::string::npos;
}

void MjcfParts::declare_triangles(const std::string& name, const FlatMesh& mesh,
                                  const MeshTriangles& triangles) {
  std::string points;
  for (const std::array<float, 3>& point : triangles.points) {
    for (const float coordinate : point) {
      if (!points.empty()) points += ' ';
      points += shortest(coordinate);
    }
  }
  std::string faces;
  for (const std::uint32_t index : triangles.indices) {
    if (!faces.empty()) faces += ' ';
    faces += std::to_string(index);
  }
  xml_.empty("mesh", {{"name", name},
                      {"vertex", std::move(points)},
                      {"face", std::move(faces)},
                      {"scale", join_numbers(mesh.scale)}});
}

void MjcfParts::add_free_joint(std::size_t i) {
  const Pose& X_WE = *flat(i).X_WE;
  xml_.empty("joint", {{"name", name(i, "free")}, {"type", "free"}});
  add_start(join_numbers(X_WE.position) + " " + quaternion_text(X_WE.orientation));
}

void MjcfParts::add_keyframe() {
  if (start_.empty()) return;
  xml_.open("keyframe");
  std::vector<XmlText::Attribute> key{{"name", "initial"}, {"qpos", start_}};
  if (!commands_.empty()) key.emplace_back("ctrl", commands_);
  xml_.empty("key", key);
  xml_.close();
}

std::string MjcfParts::finish() {
  losses_.table();
  losses_.files_in_archives();
  return xml_.finish();
}

void MjcfParts::add_solid(std::size_t i) {
  const FlatInstance& instance = flat(i);
  if (instance.shapes.empty()) {
    losses_.entity(i, "MuJoCo knows no entities of type `" + instance.type + "`");
    return;
  }
  const bool moves = is_movable(instance);
  if (moves) {
    xml_.open("body", {{"name", name(i, "link")},
                       {"pos", join_numbers(instance.X_WE->position)},
                       {"quat", quaternion_text(instance.X_WE->orientation)}});
    add_free_joint(i);
    LinkInertial mass = solid_mass(instance.shapes.front().geometry, mass_of(instance));
    mass.X_LC = instance.shapes.front().X_ES;
    add_inertial(mass, true, place_of(scene_.scene.entity(linked(i))), instance.path);
  }
  // MuJoCo allows planes only in the world body, so objects that do not move get no own body.
  const Contacts contacts = contacts_of(instance.properties);
  for (const FlatShape& shape : instance.shapes) {
    const Pose pose = moves ? shape.X_ES : *instance.X_WE * shape.X_ES;
    if (std::holds_alternative<FlatHeightmap>(shape.geometry)) {
      const auto known = heightmaps_.find(&shape);
      if (known == heightmaps_.end()) continue;
      xml_.empty("geom", {{"class", "solid"},
                          {"type", "hfield"},
                          {"hfield", known->second},
                          {"pos", join_numbers(pose.position)},
                          {"quat", quaternion_text(pose.orientation)}});
    } else if (auto geom = geom_of("solid", shape.geometry)) {
      add_geom(std::move(*geom), pose, shape.color, contacts);
    }
  }
  if (moves) xml_.close();
}

}  // namespace smurf
