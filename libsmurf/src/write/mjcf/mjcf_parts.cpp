// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf/mjcf_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "base/text/unique_names.hpp"
#include "link/kinematics.hpp"
#include "link/link_overlaps.hpp"
#include "write/parts/body_inertia.hpp"
#include "write/parts/height_range.hpp"
#include "write/parts/joint_drives.hpp"

namespace smurf {
namespace {

using Geom = std::pair<std::string, std::string>;

/// A geom with these sizes; none if a size is not positive, which MuJoCo does not load.
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
constexpr double kUsualFriction = 0.8;     // of MARS: WorldPhysics.cpp

/// Only sliding friction has a value in SMURF; torsional and rolling friction keep the defaults of
/// MuJoCo.
std::string friction_text(double sliding) { return join_numbers({sliding, 0.005, 0.0001}); }

}  // namespace

std::string quaternion_text(const Quaternion& q) { return join_numbers({q.w, q.x, q.y, q.z}); }

MjcfParts::MjcfParts(const SceneExport& scene)
    : scene_(scene), losses_(scene, SceneColumn::mjcf, "MJCF"), meshes_(scene, xml_, losses_) {
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
  const XmlText::Attributes option{
      {"timestep", format_number(physics.step_size.value_or(kUsualStep))},
      {"gravity", join_numbers(physics.gravity.value_or(kUsualGravity))},
      {"integrator", "implicit"}};
  if (scene_.contacts.choice == SelfCollision::all) {
    xml_.open("option", option);
    xml_.empty("flag", {{"filterparent", "disable"}});
    xml_.close();
  } else {
    xml_.empty("option", option);
  }
  xml_.open("default");
  add_class("visual", {{"contype", "0"}, {"conaffinity", "0"}, {"group", "2"}});
  // Shapes without a bitmask collide with all that have one, as in MARS.
  const XmlText::Attribute type{"contype", has_bitmasks_ ? kAllBits : "1"};
  const XmlText::Attribute affinity{"conaffinity", has_bitmasks_ ? kAllBits : "1"};
  const XmlText::Attribute friction{"friction", friction_text(kUsualFriction)};
  // Viewers show the groups 0 to 2. Shapes without a separate visual are in group 0.
  add_class("collision", {type, affinity, friction, {"group", "3"}});
  add_class("solid", {type, affinity, friction, {"group", "0"}});
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
    geom.emplace_back("friction", friction_text(*contacts.friction1));
    // Of two shapes, MuJoCo uses the larger friction, unless one shape has a higher priority.
    geom.emplace_back("priority", "1");
  }
  xml_.empty("geom", geom);
}

const JointSpring* MjcfParts::spring_of(const LinkedModel& model, const urdf::Joint& joint) {
  auto known = springs_.find(&model);
  if (known == springs_.end()) known = springs_.emplace(&model, springs_of(model)).first;
  const auto found = known->second.find(joint.name.value_or(""));
  return found != known->second.end() ? &found->second : nullptr;
}

double MjcfParts::armature_of(const LinkedModel& model, const urdf::Joint& joint) {
  auto known = armatures_.find(&model);
  if (known == armatures_.end()) known = armatures_.emplace(&model, armatures_of(model)).first;
  const auto found = known->second.find(joint.name.value_or(""));
  return found != known->second.end() ? found->second : 0;
}

/// Meshes of old scenes.
void MjcfParts::add_meshes_of_entities() {
  for (std::size_t i = 0; i < count(); ++i) {
    for (const FlatShape& shape : flat(i).shapes) {
      const auto* mesh = std::get_if<FlatMesh>(&shape.geometry);
      if (mesh == nullptr || !flat(i).X_WE || meshes_.name_of(*mesh) != nullptr) continue;
      const Span place = place_of(*flat(i).entity);
      const std::string reason =
          scene_.meshes.triangles ? meshes_.declare(*mesh, place) : "is not available";
      if (!reason.empty()) losses_.unseen_shape(place, shape.geometry, reason);
    }
  }
}

void MjcfParts::add_heightmaps() {
  for (std::size_t i = 0; i < count(); ++i) {
    for (const FlatShape& shape : flat(i).shapes) {
      const auto* map = std::get_if<FlatHeightmap>(&shape.geometry);
      if (map == nullptr || !flat(i).X_WE) continue;
      const std::string fault = fault_of_heightmap(map->file);
      if (!fault.empty()) {
        const std::string which = "heightmap " + quoted(map->file);
        if (flat(i).shapes.size() == 1) {
          losses_.entity(i, "its " + which + " " + fault);
        } else {
          losses_.shape(place_of(*flat(i).entity), "the " + which + ", which " + fault + ",");
        }
        continue;
      }
      declare_heights(i, shape, *map);
    }
  }
}

/// MuJoCo stretches the heights from the darkest pixel to the brightest one; in SMURF, `height` is
/// that of white.
void MjcfParts::declare_heights(std::size_t i, const FlatShape& shape, const FlatHeightmap& map) {
  HeightRange range;
  range.brightest = 1;
  const FileContent image = scene_.meshes.image ? scene_.meshes.image(map.file) : FileContent{};
  const bool is_read = scene_.meshes.image && image.status == ReadStatus::ok;
  if (is_read) range = height_range(image.text, scene_.meshes.most_pixels);
  if (!is_read || !range.is_grey) {
    losses_.note(kUnsureHeights, place_of(*flat(i).entity), flat(i).path);
  }
  // An old scene may have several heightmaps.
  const std::size_t index = static_cast<std::size_t>(&shape - flat(i).shapes.data());
  const std::string own_name =
      index == 0 ? flat(i).path : name(i, "heights_" + std::to_string(index));
  // MuJoCo refuses a height of 0; an image of one grey has the height 0 there, whatever the size.
  const double span = map.height * (range.brightest - range.darkest);
  const double lift = map.height * range.darkest;
  heightmaps_.emplace(&shape, DeclaredHeights{own_name, lift});
  xml_.empty("hfield",
             {{"name", own_name},
              {"file", map.file},
              {"size", join_numbers({map.length / 2, map.width / 2, span > 0 ? span : map.height,
                                     lift + map.height / 10 + 0.01})}});
}

void MjcfParts::add_lights() {
  UniqueNames names;
  for (const Light* light : world_lights(scene_)) {
    const Rgba white{1, 1, 1, 1};
    const auto rgb = [](const Rgba& color) { return join_numbers({color[0], color[1], color[2]}); };
    const bool is_spot = light->type.value_or(1) == 2;
    xml_.empty("light", {{"name", names.add(light->name.value_or("light"))},
                         {"pos", join_numbers(light->position.value_or({0, 0, 0}))},
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
    const std::string* name = meshes_.name_of(*mesh);
    if (name == nullptr) return std::nullopt;
    return {{{"class", geom_class}, {"type", "mesh"}, {"mesh", *name}}};
  }
  const auto geom = solid_geom(geometry);
  if (!geom) return std::nullopt;
  return {{{"class", geom_class}, {"type", geom->first}, {"size", geom->second}}};
}

std::string MjcfParts::fault_of_heightmap(const std::string& file) const {
  const bool is_named_so = path::to_lower(path::extension(file)) == ".png";
  if (is_named_so && is_png(file)) {
    const FileContent image = scene_.meshes.image ? scene_.meshes.image(file) : FileContent{};
    const bool is_read = scene_.meshes.image && image.status == ReadStatus::ok;
    return is_read ? height_range(image.text, scene_.meshes.most_pixels).fault : "";
  }
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

void MjcfParts::add_free_joint(const std::string& name, const Pose& X_WB) {
  xml_.empty("joint", {{"name", name}, {"type", "free"}});
  keys_.add_free(join_numbers(X_WB.position) + " " + quaternion_text(X_WB.orientation));
}

double MjcfParts::start_of(std::size_t i, const urdf::Joint& joint) {
  const LinkedModel& model = *robot_of(i);
  const auto [known, is_new] = starts_.try_emplace({&model, flat(i).joint_pose});
  if (is_new) known->second = held(model, scene_.joint_positions(i));
  return start_position(model, joint, known->second);
}

JointPositions MjcfParts::held(const LinkedModel& model, JointPositions given) const {
  if (scene_.motors.kind != MotorKind::automatic) return given;
  for (const auto& [name, position] : rest_positions(model)) {
    const urdf::Joint* bounded = model.find_joint(name);
    if (bounded == nullptr || bounded->mimic) continue;
    double& start = given[name];
    if (start == 0) start = position;
  }
  return given;
}

std::size_t MjcfParts::pose_sets_of(const LinkedModel& model) const {
  const auto states = scene_.group_states.find(&model);
  return model.annotations.poses.size() +
         (states != scene_.group_states.end() ? states->second.size() : 0);
}

void MjcfParts::add_keyframes() {
  std::size_t most = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    if (robot_of(i) != nullptr && flat(i).X_WE) most += pose_sets_of(*robot_of(i));
  }
  std::vector<MjcfKeys::Posed> sets;
  if (keys_.has_room_for(most)) {
    for (std::size_t i = 0; i < count(); ++i) append_pose_sets(i, sets);
  } else {
    lose_pose_sets("keyframes, which have the positions of all joints, would be too long");
  }
  keys_.write(xml_, sets,
              [&](std::size_t i, const urdf::Joint& joint, const JointPositions& positions) {
                return start_position(*robot_of(i), joint, positions);
              });
}

void MjcfParts::append_pose_sets(std::size_t i, std::vector<MjcfKeys::Posed>& sets) const {
  const LinkedModel* model = robot_of(i);
  if (model == nullptr || !flat(i).X_WE) return;
  for (const JointPoseSet& set : model->annotations.poses) {
    if (!set.name) continue;
    sets.push_back({i, name(i, *set.name), held(*model, to_joint_positions(*model, set))});
  }
  const auto states = scene_.group_states.find(model);
  if (states == scene_.group_states.end()) return;
  for (const auto& [state, positions] : states->second) {
    sets.push_back({i, name(i, state), held(*model, positions)});
  }
}

void MjcfParts::lose_pose_sets(std::string_view why) {
  for (const LinkedModel& model : scene_.scene.models) {
    const std::size_t sets = pose_sets_of(model);
    if (sets == 0 || !model.robot) continue;
    scene_.losses.report(rules::sml8211_lost_part, {model.robot->document.source, 0, 0},
                         counted(sets, "joint pose set") + " of " + quoted(model.path) +
                             (sets == 1 ? " is" : " are") +
                             " not in the MJCF: " + std::string(why));
  }
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
    add_free_joint(name(i, "free"), *instance.X_WE);
    LinkInertial mass = solid_mass(instance.shapes.front().geometry, mass_of(instance));
    mass.X_LC = instance.shapes.front().X_ES;
    add_inertial(mass, true, place_of(*flat(i).entity), instance.path);
  }
  // MuJoCo allows planes only in the world body, so objects that do not move get no own body.
  const Contacts contacts = contacts_of(instance.properties);
  for (const FlatShape& shape : instance.shapes) {
    const Pose pose = moves ? shape.X_ES : *instance.X_WE * shape.X_ES;
    if (std::holds_alternative<FlatHeightmap>(shape.geometry)) {
      const auto known = heightmaps_.find(&shape);
      if (known == heightmaps_.end()) continue;
      const auto& [heights, lift] = known->second;
      add_geom({{"class", "solid"},
                {"type", "hfield"},
                {"hfield", heights},
                {"name", geom_names_.add(instance.path)}},
               pose * Pose{{0, 0, lift}, {}}, shape.color, contacts);
    } else if (auto geom = geom_of("solid", shape.geometry)) {
      geom->emplace_back("name", geom_names_.add(instance.path));
      add_geom(std::move(*geom), pose, shape.color, contacts);
    }
  }
  if (moves) xml_.close();
}

}  // namespace smurf
