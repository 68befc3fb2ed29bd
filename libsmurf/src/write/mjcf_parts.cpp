// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf_parts.hpp"

#include "base/numbers.hpp"
#include "base/path.hpp"

namespace smurf {
namespace {

/// Type and size attributes of a geom; none for what is no geom of MuJoCo's or is reported.
std::optional<std::pair<std::string, std::string>> geom_of(const FlatGeometry& geometry) {
  using Geom = std::pair<std::string, std::string>;
  if (const auto* box = std::get_if<FlatBox>(&geometry)) {
    return Geom{"box", join_numbers({box->size[0] / 2, box->size[1] / 2, box->size[2] / 2})};
  }
  if (const auto* sphere = std::get_if<FlatSphere>(&geometry)) {
    return Geom{"sphere", join_numbers({sphere->radius})};
  }
  if (const auto* cylinder = std::get_if<FlatCylinder>(&geometry)) {
    return Geom{"cylinder", join_numbers({cylinder->radius, cylinder->length / 2})};
  }
  if (const auto* capsule = std::get_if<FlatCapsule>(&geometry)) {
    return Geom{"capsule", join_numbers({capsule->radius, capsule->length / 2})};
  }
  if (const auto* plane = std::get_if<FlatPlane>(&geometry)) {
    return Geom{"plane", join_numbers({plane->length / 2, plane->width / 2, 1})};
  }
  return std::nullopt;
}

}  // namespace

std::string quaternion_text(const Quaternion& q) { return join_numbers({q.w, q.x, q.y, q.z}); }

/// R I R^T in MuJoCo's order: MuJoCo takes no orientation together with a full tensor.
std::string full_inertia(const LinkInertial& mass) {
  const std::array<double, 9> R = to_matrix(mass.X_LC.orientation);
  const std::array<double, 9> I{mass.ixx, mass.ixy, mass.ixz, mass.ixy, mass.iyy,
                                mass.iyz, mass.ixz, mass.iyz, mass.izz};
  std::array<double, 9> rotated{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
          rotated[3 * i + j] += R[3 * i + k] * I[3 * k + l] * R[3 * j + l];
        }
      }
    }
  }
  return join_numbers({rotated[0], rotated[4], rotated[8], rotated[1], rotated[2], rotated[5]});
}

void MjcfParts::add_settings() {
  // Bodies without mass stay so: the weight of a model is not to be guessed from its shapes.
  xml_.empty("compiler", {{"angle", "radian"},
                          {"boundmass", "0"},
                          {"balanceinertia", "false"},
                          {"inertiafromgeom", "false"}});
  const FlatPhysics& physics = scene_.flat.physics;
  const Vector3 gravity = physics.gravity.value_or(Vector3{0, 0, -9.81});
  xml_.empty("option", {{"timestep", format_number(physics.step_size.value_or(0.01))},
                        {"gravity", join_numbers(gravity)}});
  xml_.open("default");
  xml_.open("default", {{"class", "visual"}});
  xml_.empty("geom", {{"contype", "0"}, {"conaffinity", "0"}, {"group", "2"}});
  xml_.close();
  xml_.open("default", {{"class", "collision"}});
  xml_.empty("geom", {{"group", "3"}});
  xml_.close();
  xml_.close();
}

void MjcfParts::add_heightmaps() {
  for (std::size_t i = 0; i < count(); ++i) {
    for (const FlatShape& shape : flat(i).shapes) {
      const auto* map = std::get_if<FlatHeightmap>(&shape.geometry);
      if (map == nullptr || !flat(i).X_WE) continue;
      if (path::to_lower(path::extension(map->file)) != ".png") {
        losses_.entity(i, "MuJoCo reads heightmaps from PNG files only");
        continue;
      }
      heightmaps_.insert(i);
      xml_.empty("hfield", {{"name", flat(i).path},
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

void MjcfParts::add_geom(const std::string& geom_class, const Pose& pose,
                         const FlatGeometry& geometry, const std::optional<Rgba>& color) {
  const auto geom = geom_of(geometry);
  if (!geom) return;
  const Rgba c = color.value_or(Rgba{0.5, 0.5, 0.5, 1});
  xml_.empty("geom", {{"class", geom_class},
                      {"type", geom->first},
                      {"size", geom->second},
                      {"pos", join_numbers(pose.position)},
                      {"quat", quaternion_text(pose.orientation)},
                      {"rgba", join_numbers({c[0], c[1], c[2], c[3]})}});
}

void MjcfParts::add_free_joint(std::size_t i) {
  const Pose& X_WE = *flat(i).X_WE;
  xml_.empty("joint", {{"name", name(i, "free")}, {"type", "free"}});
  add_start(join_numbers(X_WE.position) + " " + quaternion_text(X_WE.orientation));
}

void MjcfParts::add_keyframe() {
  if (start_.empty()) return;
  xml_.open("keyframe");
  xml_.empty("key", {{"name", "initial"}, {"qpos", start_}});
  xml_.close();
}

std::string MjcfParts::finish() {
  using enum SceneLosses::World;
  losses_.world({solver, environment});
  losses_.annotations_and_properties();
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
  if (std::holds_alternative<FlatHeightmap>(instance.shapes.front().geometry)) {
    if (!heightmaps_.contains(i)) return;
    xml_.empty("geom", {{"class", "collision"},
                        {"type", "hfield"},
                        {"hfield", instance.path},
                        {"pos", join_numbers(instance.X_WE->position)},
                        {"quat", quaternion_text(instance.X_WE->orientation)}});
    return;
  }
  if (moves) {
    xml_.open("body", {{"name", name(i, "link")},
                       {"pos", join_numbers(instance.X_WE->position)},
                       {"quat", quaternion_text(instance.X_WE->orientation)}});
    add_free_joint(i);
    LinkInertial mass = solid_mass(instance.shapes.front().geometry, mass_of(instance));
    mass.X_LC = instance.shapes.front().X_ES;
    xml_.empty("inertial", {{"pos", join_numbers(mass.X_LC.position)},
                            {"mass", format_number(mass.mass)},
                            {"fullinertia", full_inertia(mass)}});
  }
  for (const FlatShape& shape : instance.shapes) {
    if (const auto* mesh = std::get_if<FlatMesh>(&shape.geometry)) {
      losses_.shape(place_of(scene_.scene.entity(linked(i))), "the mesh `" + mesh->file + "`");
    }
  }
  // Planes stand in the world body only, so that what does not move has no body.
  for (const FlatShape& shape : instance.shapes) {
    add_geom("collision", moves ? shape.X_ES : *instance.X_WE * shape.X_ES, shape.geometry,
             shape.color);
  }
  if (moves) xml_.close();
}

}  // namespace smurf
