// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS SMURFLoader.cpp:315-548, SimEntity.cpp:344-501, EntityManager.cpp:265-291,
// primitives.cpp; Phobos multiple.py; orogen-mars RobotTeleportation.
#include "ast/scene_keys.hpp"

namespace smurf {
namespace {

using enum ValueType;

constexpr KeySpec kEntity[] = {
    {.name = "name",
     .type = text,
     .doc = "Name of the entity; `parent` and `anchor` of others refer to it, so it is unique.",
     .names = defines(NameKind::entity)},
    {.name = "file",
     .type = text,
     .doc = "Model, scene or data file, relative to the folder of this scene.",
     .is_path = true},
    {.name = "type",
     .type = text,
     .doc = "smurf, urdf, smurfs, smurfa, scn, scene, yml, primitive or a type of a plug-in; the "
            "default is the extension of `file`.",
     .read_by = "MARS 1"},
    {.name = "position",
     .type = position,
     .doc = "Position of the root link's frame in the parent's frame.",
     .unit = "m",
     .fallback = "[0, 0, 0]"},
    {.name = "rotation",
     .type = rotation,
     .doc =
         "Rotation of the root link's frame in the parent's frame: one number is an angle about z, "
         "three are angles about the fixed axes x, then y, then z (all in degrees), four are a "
         "unit quaternion w, x, y, z.",
     .unit = "deg",
     .fallback = "[1, 0, 0, 0]"},
    {.name = "parent",
     .type = frame,
     .doc = "Frame that position and rotation refer to: `world`, or `ENTITY::LINK`.",
     .fallback = "\"world\"",
     .read_by = "MARS 1, Phobos 2",
     .names = {NameKind::entity | NameKind::link}},
    {.name = "anchor",
     .type = frame,
     .doc = "Frame that the root link is fixed to: `none`, `world`, `parent` (the link named by "
            "`parent`), or `ENTITY::LINK`. Anchoring does not move the entity.",
     .fallback = "\"none\"",
     .names = {NameKind::entity | NameKind::link}},
    {.name = "pose",
     .type = text,
     .doc = "Name of the joint pose set (`poses` of the model) that the model starts in.",
     .read_by = "MARS 1, MARS 2",
     .names = {NameKind::pose}},
    {.name = "poses",
     .type = list,
     .doc = "Joint pose sets of this entity, in addition to those of its model.",
     .read_by = "MARS 1"},
    {.name = "URI",
     .type = text,
     .doc = "File of an entity in scenes of Phobos 0.6; MARS replaces the key by the contents of "
            "the file.",
     .read_by = "MARS 1"},
    {.name = "root",
     .type = boolean,
     .doc =
         "Marks the root of an assembly: in a list `smurfa`, only such entities get the parent and "
         "anchor of the including entity.",
     .fallback = "false",
     .read_by = "MARS 1"},
    {.name = "main_entity",
     .type = boolean,
     .doc = "Marks the entity that MARS plug-ins treat as the main entity.",
     .fallback = "false",
     .read_by = "MARS 1"},
    {.name = "assembly",
     .type = text,
     .doc = "Name of the assembly; MARS sets it for entities of a list `smurfa`.",
     .read_by = "MARS 1"},
    {.name = "data_package",
     .type = integer,
     .doc = "Data that the joint of the anchor publishes: 0 none, 1 a reduced set.",
     .read_by = "MARS 1",
     .minimum = 0},
    {.name = "child",
     .type = text,
     .doc = "Link that Phobos attaches when it assembles models; the default is the root link.",
     .read_by = "Phobos 2",
     .names = {NameKind::link}},
    {.name = "geometry",
     .type = mapping,
     .doc = "Shape of an entity of type `primitive`: `type` is plane, box, sphere, cylinder or "
            "capsule.",
     .read_by = "MARS 1"},
    {.name = "teleportation_targets",
     .type = list,
     .doc =
         "Poses that the Rock task RobotTeleportation moves the entity to, each a partial entity.",
     .read_by = "Rock"},
};

constexpr KeySpec kOde[] = {
    {.name = "stepsize",
     .type = number,
     .doc = "Length of one step, in milliseconds (Phobos' script for PyBullet takes seconds).",
     .unit = "ms",
     .fallback = "10",
     .minimum = 0},
    {.name = "cfm",
     .type = number,
     .doc = "Global constraint force mixing.",
     .fallback = "1e-10",
     .minimum = 0},
    {.name = "erp",
     .type = number,
     .doc = "Global error reduction per step.",
     .fallback = "0.1",
     .minimum = 0,
     .maximum = 1},
};

constexpr KeySpec kPhysics[] = {
    {.name = "gravity",
     .type = vector3,
     .doc = "Acceleration of free fall in the world frame; a missing component is 0.",
     .unit = "m/s^2",
     .fallback = "{\"x\": 0, \"y\": 0, \"z\": -9.81}"},
    {.name = "ode",
     .type = mapping,
     .doc = "Parameters of the physics engine ODE.",
     .members = kOde},
    {.name = "bullet",
     .type = mapping,
     .doc = "Parameters of the physics engine Bullet, read by Phobos' script for PyBullet only.",
     .read_by = "Phobos 2"},
};

constexpr KeySpec kSkybox[] = {
    {.name = "path",
     .type = text,
     .doc = "Folder of the images, relative to the scene's folder when it exists there."},
};

constexpr KeySpec kAnimations[] = {
    {.name = "config_path", .type = text, .doc = "Configuration file of the animations."},
};

constexpr KeySpec kTerrain[] = {
    {.name = "path", .type = text, .doc = "Folder of the terrain data."},
    {.name = "mesh", .type = text, .doc = "Mesh of the terrain."},
    {.name = "mesh_material", .type = any, .doc = "Material of the mesh."},
    {.name = "mesh_scale", .type = any, .doc = "Scale of the mesh."},
};

constexpr KeySpec kFog[] = {
    {.name = "density", .type = number, .doc = "Density of the fog.", .minimum = 0},
    {.name = "start", .type = number, .doc = "Distance at which the fog begins.", .unit = "m"},
    {.name = "end", .type = number, .doc = "Distance at which the fog is full.", .unit = "m"},
    {.name = "color", .type = color, .doc = "Colour of the fog."},
};

constexpr KeySpec kEnvironment[] = {
    {.name = "skybox", .type = mapping, .doc = "Images of the sky.", .members = kSkybox},
    {.name = "animations", .type = mapping, .doc = "Animated characters.", .members = kAnimations},
    {.name = "terrain",
     .type = mapping,
     .doc = "Terrain that is shown, without physics.",
     .members = kTerrain},
    {.name = "background", .type = color, .doc = "Background colour."},
    {.name = "fog",
     .type = mapping,
     .doc = "Fog; without this key, fog is switched off.",
     .members = kFog},
};

constexpr KeySpec kScene[] = {
    {.name = "plugins",
     .type = name_list,
     .doc = "MARS plug-in libraries to load.",
     .read_by = "MARS 1, MARS 2"},
    {.name = "smurfs",
     .type = list,
     .doc = "Entities; the old name of `entities`, read first.",
     .read_by = "MARS 1, Phobos 2",
     .members = kEntity},
    {.name = "entities", .type = list, .doc = "The entities of the scene.", .members = kEntity},
    {.name = "smurfa",
     .type = list,
     .doc = "Entities of an assembly; only entities with `root: true` get the anchor of the "
            "assembly.",
     .read_by = "MARS 1, Phobos 2",
     .members = kEntity},
    {.name = "physics",
     .type = mapping,
     .doc = "Gravity and parameters of the physics engine.",
     .read_by = "MARS 1, MARS 2",
     .members = kPhysics},
    {.name = "environment",
     .type = mapping,
     .doc = "Sky, terrain, background and fog; without `fog` in it, fog is switched off.",
     .read_by = "MARS 1, MARS 2",
     .members = kEnvironment},
    {.name = "lights", .type = list, .doc = "Lights, in the world frame.", .read_by = "MARS 1"},
};

/// The row of a table by its key.
template <std::size_t N>
consteval KeySpec row(const KeySpec (&table)[N], std::string_view name) {
  for (const KeySpec& spec : table) {
    if (spec.name == name) return spec;
  }
  throw "no such key";
}

constexpr Key<Entity> kEntityKeys[] = {
    {row(kEntity, "name"), &Entity::name},     {row(kEntity, "file"), &Entity::file},
    {row(kEntity, "type"), &Entity::type},     {row(kEntity, "position"), &Entity::position},
    {row(kEntity, "parent"), &Entity::parent}, {row(kEntity, "anchor"), &Entity::anchor},
    {row(kEntity, "pose"), &Entity::pose},     {row(kEntity, "URI"), &Entity::uri},
    {row(kEntity, "root"), &Entity::root},
};

constexpr Key<Physics> kPhysicsKeys[] = {
    {row(kPhysics, "gravity"), &Physics::gravity},
};

constexpr Key<Physics> kOdeKeys[] = {
    {row(kOde, "stepsize"), &Physics::step_size},
    {row(kOde, "cfm"), &Physics::cfm},
    {row(kOde, "erp"), &Physics::erp},
};

}  // namespace

std::span<const KeySpec> scene_keys() { return kScene; }
std::span<const KeySpec> all_entity_keys() { return kEntity; }
std::span<const KeySpec> environment_keys() { return kEnvironment; }
std::span<const KeySpec> all_physics_keys() { return kPhysics; }
std::span<const Key<Entity>> entity_keys() { return kEntityKeys; }
std::span<const Key<Physics>> physics_keys() { return kPhysicsKeys; }
std::span<const Key<Physics>> ode_keys() { return kOdeKeys; }

}  // namespace smurf
