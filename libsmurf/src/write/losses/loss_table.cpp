// SPDX-License-Identifier: BSD-3-Clause
#include "write/losses/loss_table.hpp"

#include "write/losses/found_things.hpp"

namespace smurf {
namespace {

constexpr Cell kept(std::string_view how) { return {Fate::kept, how}; }
constexpr Cell partly(std::string_view what) { return {Fate::partly, what}; }
constexpr Cell changed(std::string_view how) { return {Fate::changed, how}; }
constexpr Cell lost(std::string_view why) { return {Fate::lost, why}; }
constexpr Cell added(std::string_view what) { return {Fate::added, what}; }
constexpr Cell kKept{Fate::kept, {}};
constexpr Cell kLost{Fate::lost, {}};
constexpr Cell kShown{Fate::shown, {}};
constexpr Cell kOfUrdf = partly("materials of the URDF");
constexpr Cell kNotApplied = lost("smurf2urdf --apply materials writes them");
constexpr Cell kDiffuse = lost("only the diffuse colour and transparency are written");
constexpr Cell kMaterialName = partly("names of materials");
constexpr std::array<Cell, kSceneColumns> kLostEverywhere{kLost, kLost, kLost, kLost,
                                                          kLost, kLost, kLost, kLost};
constexpr Cell kNoPlace = lost("SDF has no element for them");
constexpr Cell kTree = lost("their links have another parent joint");
constexpr Cell kLoop = partly("hinges and rigid ones, as joints to a second parent");
constexpr Cell kUnreached = lost("nothing says where they are");
constexpr Cell kSpeed = lost("MuJoCo does not limit speeds");
constexpr Cell kEffort =
    lost("only actuators have them in MuJoCo, and these joints have no motor; `urdf2smurf --motors "
         "all` adds motors");
constexpr Cell kActuator = partly("actuators, where one joint is driven, without other settings");
constexpr Cell kDrive = partly("drives, where one joint is driven, without other settings");
constexpr Cell kFields = partly("poses and fields of view of sensors");
constexpr Cell kGazeboOnly = lost("only Gazebo reads them");
constexpr Cell kAsGazebo = partly("as Gazebo converts them, if their link or joint exists");
constexpr Cell kPlugin = lost("Gazebo leaves them to a plug-in that reads the URDF");
constexpr Cell kNearest = changed("to the nearest inertia that the simulator accepts");
constexpr Cell kTenGrams = added("10 g in a ball of 1 cm, the default of MARS");
constexpr Cell kOfShapes =
    added("those of the shapes, filled with the mass, if the shapes are closed");
constexpr Cell kUseful =
    added("those of the shapes, filled with the mass; without closed shapes those of a ball of the "
          "density of water");
constexpr Cell kReadMeshes =
    kept("meshes that are STL, OBJ, bobj, COLLADA or glTF, without skins and textures");
constexpr Cell kFixedWorld =
    added("them fixed to the world, as readers of URDFs do; `anchor: none` or --base floating "
          "frees them, as in MARS");
constexpr Cell kGains = added(
    "a damping of 10 times the largest effort divided by the largest speed, 100 without "
    "these limits, and for positions a stiffness of `p` times that, 20 times without `p`; --kp, --kv "
    "and --actuator choose others");
constexpr Cell kStableGains = added(
    "a damping of 10 times the largest effort divided by the largest speed, 100 without "
    "these limits, and for positions a stiffness of `p` times that, 20 times without `p`; where this "
    "damping is too fast for the inertia and the step, the rest of it is that of the joint, at most "
    "the largest effort divided by the largest speed, or a motor of speeds has an armature; "
    "a motor that states both `kp` and `kv` keeps them; --kp, --kv, --armature and --actuator choose "
    "others");
constexpr Cell kBoundedServo = added(
    "other ones where a motor with these is not stable at the step, swings, does not hold the "
    "weight, or does not arrive in 2 s; --kp and --kv choose others");
constexpr Cell kPlainName =
    changed("names have ASCII letters, digits and _ only, are unique, and are not reserved");
constexpr Cell kHulls =
    changed("MuJoCo uses the convex hull, which has this multiple of the volume, so that gaps are "
            "full; --collision parts divides them into convex parts");
constexpr Cell kSquare =
    changed("Gazebo refuses images that are not square with 2^n + 1 pixels a side, such as 129; "
            "give the image such a size");
constexpr Cell kOwnContacts =
    kept("none, as Gazebo makes of a URDF, unless `self_collide` or --self-collision lets links "
         "touch");
constexpr Cell kNoPairs =
    lost("`self_collide` is for all links of a model, and bitmasks are for all models; "
         "--self-collision none lets none of its links touch");
constexpr Cell kColours = lost("shapes have colours");

constexpr SceneThing kThings[] = {
    // In the URDF.       sdf, sdf16, mjcf, urdf, dmd, html, gltf, usda
    {.title = "masses and inertias",
     .in_model = things::masses,
     .cells = {kKept, kKept, kKept, kKept, kKept, kKept, kShown, kKept}},
    {.title = kInventedMasses,
     .cells = {kTenGrams, kTenGrams, kTenGrams, kKept, kKept, kKept, kKept, kTenGrams}},
    {.title = kAbsentInertias,
     .cells = {kOfShapes, kOfShapes, kOfShapes, kKept, kKept, kKept, kKept, kOfShapes}},
    {.title = kUselessInertias,
     .cells = {kUseful, kUseful, kUseful, kKept, kKept, kKept, kKept, kUseful}},
    {.title = kRefusedInertias,
     .cells = {kNearest, kNearest, kNearest, kKept, kKept, kKept, kKept,
               changed("USD computes moments of inertia of 0 from shapes")}},
    {.title = "visual shapes",
     .cells = {kKept, kept("capsules are lost"), kReadMeshes, kKept, kKept, kReadMeshes,
               kReadMeshes, kReadMeshes}},
    {.title = "collision shapes",
     .in_model = things::collision_shapes,
     .cells = {kKept, kept("capsules are lost"), kReadMeshes, kKept, kKept, kReadMeshes, kShown,
               kReadMeshes}},
    {.title = "concave meshes of collisions",
     .in_model = things::concave_meshes,
     .cells = {kKept, kKept, kHulls, kKept, kKept, kKept, kShown,
               kept("those that move as their convex hulls, for PhysX")}},
    {.title = kEmptyShapes,
     .cells = {kKept, kKept, lost("MuJoCo refuses them"), kKept, kKept, kKept, kKept, kKept}},
    {.title = "names of visuals and collisions",
     .cells = {kKept, kKept, kKept, kKept, kKept, kKept, kShown, kept("as attributes")}},
    {.title = "colours", .cells = {kKept, kKept, kKept, kKept, kKept, kKept, kKept, kKept}},
    {.title = kColorsOfMeshes,
     .cells = {kKept, kKept,
               lost("MuJoCo shows a mesh in one colour, and refuses a flat part as a mesh"), kKept,
               kKept, kKept, kKept, kKept}},
    {.title = "textures",
     .in_model = things::textures,
     .cells = {kept("as albedo maps"), lost("SDF 1.6 has scripts of Gazebo Classic for them"),
               partly("PNG files, but not those that a mesh file names"), kKept, kKept,
               partly("PNG and JPEG files, but not those that a mesh file names"), kColours,
               kColours}},
    {.title = "movable joints",
     .in_model = things::movable_joints,
     .cells = {kept("planar ones as fixed"), kept("planar ones as fixed"),
               kept("planar and floating ones as fixed"), kKept, kKept,
               kept("planar and floating ones as fixed"), kShown, kKept}},
    {.title = "joints that close a loop",
     .in_model = things::closing_joints,
     .cells = {kLoop, kLoop, partly("hinges and rigid ones, as `connect` and `weld`"), kKept, kKept,
               kShown, kShown, kTree}},
    {.title = "joints and links that the root does not reach",
     .in_model = things::unreached_parts,
     .cells = {kUnreached, kUnreached, kUnreached, kKept, kKept, kUnreached, kUnreached,
               kUnreached}},
    {.title = "mimicking joints",
     .cells = {changed("for Gazebo Harmonic and later; before, they move without their leader"),
               changed("they move without their leader"), kept("as equalities"), kKept, kKept,
               kKept, kShown, kept("for PhysX")}},
    {.title = "position limits",
     .cells = {kKept, kKept, kKept, kKept, kKept, kKept, kShown, kKept}},
    {.title = "effort limits",
     .in_motors = things::efforts,
     .cells = {kKept, kKept, kEffort, kKept, kKept, kKept, kShown, kept("of drives")}},
    {.title = "velocity limits",
     .in_model = things::velocities,
     .cells = {kKept, kKept, kSpeed, kKept, kKept, kKept, kShown, kept("for PhysX")}},
    {.title = "soft limits and safety controllers",
     .in_model = things::safety_controllers,
     .cells = {kNoPlace, kNoPlace, kLost, kKept, kKept, kShown, kShown, kLost}},
    {.title = "calibrations of joints",
     .in_model = things::calibrations,
     .cells = {kNoPlace, kNoPlace, kLost, kKept, kKept, kShown, kShown, kLost}},
    {.title = "limits of acceleration and jerk",
     .in_model = things::newer_limits,
     .cells = {kNoPlace, kNoPlace, kLost, kKept, kKept, kShown, kShown, kLost}},
    {.title = "damping and friction of joints",
     .in_model = things::joint_frictions,
     .cells = {kKept, kKept, kKept, kKept, kKept, kKept, kShown, kept("friction for PhysX")}},
    {.title = "transmissions",
     .in_motors = things::transmissions,
     .cells = {kPlugin, kPlugin, kActuator, kKept, kKept, kShown, kShown, kDrive}},
    {.title = "elements of ros2_control",
     .in_motors = things::ros2_controls,
     .cells = {kPlugin, kPlugin, kActuator, kKept,
               lost("Drake makes actuators of `<transmission>` only"), kShown, kShown, kDrive}},
    {.title = "reserved names of links and joints",
     .in_scene = things::reserved_names,
     .cells = {changed("SDF reserves `world`, `true`, `false`, names such as `__this__`, and `::` "
                       "outside of nested models"),
               changed("SDF reserves `world`, `true`, `false`, names such as `__this__`, and `::`"),
               kKept, kKept, kKept, kKept, kKept, kKept}},
    {.title = "collisions within a robot",
     .in_scene = things::own_collisions,
     .cells = {kOwnContacts, kOwnContacts, kKept, kKept, kKept, kKept, kKept,
               added("none, as in NVIDIA's importer of URDFs, because convex hulls overlap; "
                     "--self-collision chooses what can touch")}},
    {.title = "pairs of links that cannot touch",
     .in_scene = things::disabled_pairs,
     .cells = {kNoPairs, kNoPairs, kept("as `exclude`"),
               lost("the SRDF of a robot says which these are"), kept("as filter groups"), kKept,
               kKept, kKept}},
    {.title = "gains of motors",
     .in_motors = things::chosen_gains,
     .cells = {kKept, kKept, kStableGains, kKept, kKept, kKept, kKept, kGains}},
    {.title = kBoundedGains,
     .cells = {kKept, kKept, kBoundedServo, kKept, kKept, kKept, kKept, kKept}},
    {.title = "elements in <gazebo>",
     .in_motors = things::gazebo_elements,
     .cells = {kAsGazebo, kAsGazebo,
               partly("sensors that MuJoCo has, and joints that close a loop"), kKept, kKept,
               kFields, kShown, kGazeboOnly}},
    {.title = kLostContacts,
     .cells = {lost("a contact sensor of Gazebo belongs to one link"),
               lost("a contact sensor of Gazebo belongs to one link"), kKept, kKept, kKept, kKept,
               kKept, kKept}},
    {.title = "systems of Gazebo for sensors",
     .in_model = things::sensor_systems,
     .cells = {added("the plug-ins of Gazebo Fortress and later that run them"), kKept, kKept,
               kKept, kKept, kKept, kKept, kKept}},
    {.title = "elements that URDF does not define",
     .in_model = things::other_extensions,
     .cells = {kLost, kLost, kLost, kKept, kKept, kShown, kShown, kLost}},
    {.title = "attributes that URDF does not define",
     .in_model = things::other_attributes,
     .cells = {kLost, kLost, kLost, kKept, kKept, kShown, kShown, kLost}},
    // Annotations.
    {.title = "motor",
     .of = ThingOf::annotation,
     .in_motors = things::motors,
     .cells = {partly("motors that drive a joint, as systems of Gazebo, if no plug-in of the robot "
                      "commands its joints"),
               kLost, partly("motors that drive a joint, as actuators"), kLost, kLost, kLost, kLost,
               partly("motors that drive a joint, as drives")}},
    {.title = "motor setting",
     .of = ThingOf::setting,
     .in_model = things::motor_keys,
     .cells = {lost("Gazebo moves a joint at up to maxSpeed, within the effort limit of the joint"),
               kKept, lost("MuJoCo has gain p and limits only"), kKept, kKept, kKept, kKept,
               lost("drives of USD have stiffness, damping, effort and speed only")}},
    {.title = "sensor",
     .of = ThingOf::annotation,
     .in_motors = things::sensors,
     .cells = {partly("types that Gazebo has"), kLost, partly("types that MuJoCo has"), kLost,
               kLost, partly("sensors on a link"), kLost, kLost}},
    {.title = "sensor setting",
     .of = ThingOf::setting,
     .in_motors = things::sensor_keys,
     .cells = {lost("Gazebo's sensors have no such setting"), kKept,
               lost("MuJoCo's sensors have no such setting"), kKept, kKept,
               lost("the page shows poses and fields of view"), kKept, kKept}},
    {.title = "controller",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::controllers>,
     .cells = kLostEverywhere},
    {.title = "material",
     .of = ThingOf::annotation,
     .in_model = things::materials,
     .cells = {kOfUrdf, kOfUrdf, kOfUrdf, kNotApplied, kNotApplied, kOfUrdf, kOfUrdf, kOfUrdf}},
    {.title = "material setting",
     .of = ThingOf::setting,
     .in_model = things::material_keys,
     .cells = {lost("diffuse colours, textures and transparency are written"), kDiffuse, kDiffuse,
               kKept, kKept, lost("the page shows diffuse colours and textures, and transparency"),
               kDiffuse, kDiffuse}},
    {.title = "collision setting",
     .of = ThingOf::setting,
     .in_model = things::collision_settings,
     .cells = {partly("bitmask and friction"), kLost, partly("bitmask and first friction"), kLost,
               kLost, kLost, kLost, partly("first friction")}},
    {.title = "joint setting",
     .of = ThingOf::setting,
     .in_model = things::entries<&Annotations::joints>,
     .cells = {kLost, kLost, partly("armature"), kLost, kLost, kLost, kLost, kLost}},
    {.title = "link setting",
     .of = ThingOf::setting,
     .in_model = things::link_settings,
     .cells = kLostEverywhere},
    {.title = "visual setting",
     .of = ThingOf::setting,
     .in_model = things::visual_settings,
     .cells = {kMaterialName, kMaterialName, kMaterialName, kLost, kLost, kMaterialName,
               kMaterialName, kMaterialName}},
    {.title = "node",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::nodes>,
     .cells = kLostEverywhere},
    {.title = "joint task",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::joint_tasks>,
     .cells = kLostEverywhere},
    {.title = "light",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::lights>,
     .cells = kLostEverywhere},
    {.title = "graphics section",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::graphics>,
     .cells = kLostEverywhere},
    {.title = "joint pose set",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::poses>,
     .cells = {kLost, kLost, kept("as keyframes"), kLost, kLost, kKept, kLost, kLost}},
    {.title = "submechanism",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::submechanisms>,
     .cells = kLostEverywhere},
    {.title = "exoskeleton",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::exoskeletons>,
     .cells = kLostEverywhere},
    {.title = "interface",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::interfaces>,
     .cells = kLostEverywhere},
    {.title = "submodel",
     .of = ThingOf::annotation,
     .in_model = things::entries<&Annotations::submodels>,
     .cells = kLostEverywhere},
    {.title = "other section",
     .of = ThingOf::annotation,
     .in_model = things::other_sections,
     .cells = kLostEverywhere},
    // In scenes and entities.
    {.title = "gravity",
     .of = ThingOf::scene,
     .setting = WorldSetting::gravity,
     .cells = {kKept, kKept, kKept, kLost, kLost, kShown, kLost, kKept}},
    {.title = "gravity when none is set",
     .of = ThingOf::scene,
     .in_scene = things::no_gravity,
     .cells = {added("9.81 m/s^2 downward, the default of MARS"),
               added("9.81 m/s^2 downward, the default of MARS"),
               added("9.81 m/s^2 downward, the default of MARS"), kKept, kKept, kKept, kKept,
               added("9.81 m/s^2 downward, the default of MARS")}},
    {.title = "step size",
     .of = ThingOf::scene,
     .setting = WorldSetting::step_size,
     .cells = {kKept, kKept, kKept, kLost, kLost, kShown, kLost, kLost}},
    {.title = "step size when none is set",
     .of = ThingOf::scene,
     .in_scene = things::no_step,
     .cells = {added("1 ms, where MARS uses 10 ms"), added("1 ms, where MARS uses 10 ms"),
               added("1 ms; MARS uses 10 ms, with which many robots are unstable here"), kKept,
               kKept, kKept, kKept, kKept}},
    {.title = "solver settings",
     .of = ThingOf::scene,
     .setting = WorldSetting::solver,
     .cells = {kKept, kKept, kLost, kLost, kLost, kShown, kLost, kLost}},
    {.title = "environment",
     .of = ThingOf::scene,
     .setting = WorldSetting::environment,
     .cells = kLostEverywhere},
    {.title = "plug-ins of MARS",
     .of = ThingOf::scene,
     .setting = WorldSetting::plugins,
     .cells = kLostEverywhere},
    {.title = "lights",
     .of = ThingOf::scene,
     .setting = WorldSetting::lights,
     .cells = {kKept, kKept, kKept, kLost, kLost, kLost, kLost,
               kept("place, direction, diffuse colour and cone")}},
    {.title = "ambient colours of lights",
     .of = ThingOf::scene,
     .in_scene = things::ambient_lights,
     .cells = {lost("SDF has one ambient colour per world"),
               lost("SDF has one ambient colour per world"), kKept, kKept, kKept, kKept, kKept,
               kLost}},
    {.title = "attenuations and specular colours of lights",
     .of = ThingOf::scene,
     .in_scene = things::light_details,
     .cells = {kKept, kKept, kKept, kKept, kKept, kKept, kKept,
               lost("light of USD falls off with the square of the distance")}},
    {.title = kUnsureHeights,
     .of = ThingOf::scene,
     .cells = {kKept, kKept,
               changed("MuJoCo stretches the red part of the image from the darkest pixel to the "
                       "brightest one"),
               kKept, kKept, kKept, kKept, kKept}},
    {.title = kOddHeights,
     .of = ThingOf::scene,
     .cells = {kSquare, kSquare, kKept, kKept, kKept, kKept, kKept, kKept}},
    {.title = "entities of other types",
     .of = ThingOf::scene,
     .cells = {kLost, kLost, kLost, kLost, kLost, kept("in the tree"), kept("as nodes"),
               kept("as Xforms")}},
    {.title = "anchors",
     .of = ThingOf::scene,
     .cells = {kKept, kKept, kKept, kKept, kKept, kKept, kShown, kKept}},
    {.title = "roots named `world` without an anchor",
     .of = ThingOf::scene,
     .in_scene = things::world_roots,
     .cells = {kFixedWorld, kFixedWorld, kFixedWorld, kFixedWorld, kKept, kKept, kKept,
               kFixedWorld}},
    {.title = "robots that move freely",
     .of = ThingOf::scene,
     .in_scene = things::free_robots,
     .cells = {kKept, kKept, kKept,
               changed("a floating joint from `world` holds each; PyBullet makes it fixed, and "
                       "Drake ignores its origin"),
               kKept, kKept, kKept, kKept}},
    {.title = "names of entities",
     .of = ThingOf::scene,
     .in_scene = things::changed_names,
     .cells = {kPlainName, kPlainName, kKept, kPlainName, kPlainName, kKept, kKept,
               kept("as attributes")}},
    {.title = "start positions",
     .of = ThingOf::scene,
     .in_scene = things::start_positions,
     .cells = {changed("they become the zero of the joints, and limits are shifted accordingly"),
               changed("they become the zero of the joints, and limits are shifted accordingly"),
               kept("in the keyframe"), kLost, kKept, kKept, kept("as poses"), kept("as poses")}},
    {.title = "keys of primitives",
     .of = ThingOf::scene,
     .in_scene = things::entity_keys,
     .cells = {partly("keys of the shape, mass, bitmask and friction"),
               partly("keys of the shape and mass"),
               partly("keys of the shape, mass, bitmask and first friction"),
               partly("keys of the shape and mass"), kKept, partly("keys of the shape"),
               partly("keys of the shape"), partly("keys of the shape, mass and first friction")}},
};

}  // namespace

std::span<const SceneThing> scene_things() { return kThings; }

}  // namespace smurf
