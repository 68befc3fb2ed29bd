// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo: bodies nested as the kinematic trees are, what is anchored inside the link it hangs on,
// and one keyframe `initial` that holds every joint's start.
#include <map>
#include <set>

#include "base/numbers.hpp"
#include "base/path.hpp"
#include "write/scene_losses.hpp"
#include "write/scene_parts.hpp"
#include "write/xml_text.hpp"

namespace smurf {
namespace {

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

class MjcfWriter {
 public:
  explicit MjcfWriter(const SceneExport& scene) : scene_(scene), losses_(scene, "MJCF") {}

  std::string run() {
    find_children();
    xml_.open("mujoco", {{"model", "scene"}});
    add_settings();
    add_assets();
    xml_.open("worldbody");
    add_lights();
    for (std::size_t i = 0; i < count(); ++i) {
      if (is_top_level_[i] && flat(i).X_WE) add_top_level(i);
    }
    xml_.close();
    add_equalities();
    if (!start_.empty()) {
      xml_.open("keyframe");
      xml_.empty("key", {{"name", "initial"}, {"qpos", start_}});
      xml_.close();
    }
    using enum SceneLosses::World;
    losses_.world({solver, environment});
    losses_.annotations_and_properties();
    return xml_.finish();
  }

 private:
  using PlaceOfLink = std::pair<std::size_t, std::size_t>;  ///< instance, link

  std::size_t count() const { return scene_.flat.instances.size(); }
  const FlatInstance& flat(std::size_t i) const { return scene_.flat.instances[i]; }
  const Instance& linked(std::size_t i) const { return scene_.scene.instances[i]; }
  const LinkedModel* robot_of(std::size_t i) const { return smurf::robot_of(scene_.scene, i); }
  std::string name(std::size_t i, std::string_view part) const {
    return flat(i).path + "/" + std::string(part);
  }
  /// What hangs on which link. A circle of anchors is cut at its end.
  void find_children() {
    const std::vector<std::size_t> ends = anchor_groups(scene_.scene);
    is_top_level_.assign(count(), true);
    for (std::size_t i = 0; i < count(); ++i) {
      const Attachment& anchor = linked(i).placement.anchor;
      if (anchor.kind != Attachment::Kind::link || !flat(i).X_WE || robot_of(i) == nullptr)
        continue;
      const std::size_t other = to_size(anchor.instance);
      const std::optional<std::size_t> link = anchor_link(scene_.scene, i);
      if (!link || !flat(other).X_WE || ends[i] == i) {
        losses_.anchor(i, "there is no link to hang it on");
        continue;
      }
      is_top_level_[i] = false;
      children_[{other, *link}].push_back(i);
    }
  }

  void add_settings() {
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

  /// Meshes and heightmaps are declared once, and only those that MuJoCo can read.
  void add_assets() {
    xml_.open("asset");
    for (std::size_t m = 0; m < scene_.scene.models.size(); ++m) {
      const LinkedModel& model = scene_.scene.models[m];
      if (!model.robot) continue;
      for (const urdf::Link& link : model.robot->links) {
        for (const urdf::Visual& visual : link.visuals) add_mesh(m, visual.geometry, visual.span);
        for (const urdf::Collision& shape : link.collisions)
          add_mesh(m, shape.geometry, shape.span);
      }
    }
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
    xml_.close();
  }

  static std::string mesh_key(const FlatMesh& mesh) {
    return mesh.file + " " + join_numbers(mesh.scale);
  }

  void add_mesh(std::size_t model, const urdf::Geometry& geometry, Span span) {
    const auto flat_geometry = to_flat(geometry, scene_.flat.models[model]);
    const auto* mesh = flat_geometry ? std::get_if<FlatMesh>(&*flat_geometry) : nullptr;
    if (mesh == nullptr || meshes_.contains(mesh_key(*mesh))) return;
    const std::string extension = path::to_lower(path::extension(mesh->file));
    bool exists = false;
    for (const MeshReference& reference : scene_.scene.models[model].meshes) {
      const auto* written = std::get_if<urdf::Mesh>(&geometry.shape);
      exists = exists || (reference.filename == *written->filename && reference.exists);
    }
    if ((extension != ".stl" && extension != ".obj") || !exists) {
      losses_.shape(span, "the mesh `" + mesh->file + "`" +
                              (exists ? ", which is neither STL nor OBJ," : ", which is missing,"));
      return;
    }
    const std::string mesh_name = "mesh_" + std::to_string(meshes_.size());
    meshes_.emplace(mesh_key(*mesh), mesh_name);
    xml_.empty("mesh",
               {{"name", mesh_name}, {"file", mesh->file}, {"scale", join_numbers(mesh->scale)}});
  }

  void add_lights() {
    for (const Light* light : world_lights(scene_.scene)) {
      const Rgba white{1, 1, 1, 1};
      const auto rgb = [](const Rgba& color) {
        return join_numbers({color[0], color[1], color[2]});
      };
      const bool is_spot = light->type.value_or(1) == 2;
      xml_.empty("light",
                 {{"pos", join_numbers(light->position.value_or({0, 0, 0}))},
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

  void add_top_level(std::size_t i) {
    if (robot_of(i) != nullptr) {
      const bool is_free = flat(i).anchor.kind != Attachment::Kind::world;
      add_robot(i, is_free);
    } else if (!flat(i).shapes.empty()) {
      add_solid(i);
    } else {
      losses_.entity(i, "MuJoCo knows no entities of type `" + flat(i).type + "`");
    }
  }

  /// One link on the way down, without recursion: files decide how deep the nesting is.
  struct Step {
    std::size_t instance = 0, link = 0;
    std::vector<PlaceOfLink> inside;
    std::size_t next = 0;
  };

  void add_robot(std::size_t top, bool is_free) {
    std::vector<Step> stack;
    const LinkedModel& model = *robot_of(top);
    const std::size_t root = to_size(model.tree.roots.front());
    open_body(top, root, *flat(top).X_WE, nullptr, is_free);
    stack.push_back({top, root, inside(top, root), 0});
    while (!stack.empty()) {
      Step& step = stack.back();
      if (step.next == step.inside.size()) {
        xml_.close();
        stack.pop_back();
        continue;
      }
      const auto [instance, link] = step.inside[step.next++];
      if (instance == step.instance) {
        open_link(instance, link);
      } else {
        const Pose X_LE =
            pose_on_anchor(scene_.scene, instance, frames_).value_or(*flat(instance).X_WE);
        open_body(instance, link, X_LE, nullptr, false);
      }
      stack.push_back({instance, link, inside(instance, link), 0});
    }
  }

  /// The links below a link, then the roots of what is anchored to it.
  std::vector<PlaceOfLink> inside(std::size_t i, std::size_t link) const {
    std::vector<PlaceOfLink> places;
    const LinkedModel& model = *robot_of(i);
    for (const JointIndex joint : model.tree.child_joints[link]) {
      places.emplace_back(i, to_size(*model.tree.joint_child[to_size(joint)]));
    }
    const auto hanging = children_.find({i, link});
    if (hanging == children_.end()) return places;
    for (const std::size_t child : hanging->second) {
      places.emplace_back(child, to_size(robot_of(child)->tree.roots.front()));
    }
    return places;
  }

  /// A body at its joint's zero; the keyframe moves it.
  void open_link(std::size_t i, std::size_t link) {
    const LinkedModel& model = *robot_of(i);
    const urdf::Joint& joint = model.joint(*model.tree.parent_joint[link]);
    open_body(i, link, urdf::to_pose(joint.origin), &joint, false);
  }

  void open_body(std::size_t i, std::size_t link, const Pose& pose, const urdf::Joint* joint,
                 bool is_free) {
    const LinkedModel& model = *robot_of(i);
    xml_.open("body", {{"name", name(i, link_name(model, link))},
                       {"pos", join_numbers(pose.position)},
                       {"quat", quaternion_text(pose.orientation)}});
    bool moves = is_free;
    if (is_free) {
      // Not <freejoint/>, which DART takes for a weld.
      xml_.empty("joint", {{"name", name(i, "free")}, {"type", "free"}});
      add_start(join_numbers(pose.position) + " " + quaternion_text(pose.orientation));
    }
    if (joint != nullptr) moves = add_joint(i, model, *joint);
    auto mass = inertial_of(model.robot->links[link]);
    if (!mass && moves) mass = smallest_mass();
    if (mass) {
      xml_.empty("inertial", {{"pos", join_numbers(mass->X_LC.position)},
                              {"mass", format_number(mass->mass)},
                              {"fullinertia", full_inertia(*mass)}});
    }
    add_geoms(i, model, model.robot->links[link]);
  }

  void add_start(const std::string& numbers) { start_ += (start_.empty() ? "" : " ") + numbers; }

  /// False when the joint does not move.
  bool add_joint(std::size_t i, const LinkedModel& model, const urdf::Joint& joint) {
    if (!joint.has_one_axis()) {
      if (joint.type != urdf::JointType::fixed && reported_.insert(&joint).second) {
        losses_.joint(joint, "fixed");
      }
      return false;
    }
    const bool is_limited = joint.type != urdf::JointType::continuous && joint.limit;
    const double lower = is_limited ? joint.limit->lower.value_or(0) : 0;
    const double upper = is_limited ? joint.limit->upper.value_or(0) : 0;
    const bool is_linear = joint.type == urdf::JointType::prismatic;
    xml_.empty(
        "joint",
        {{"name", name(i, joint.name.value_or(""))},
         {"type", is_linear ? "slide" : "hinge"},
         {"axis", join_numbers(joint.axis.value_or({1, 0, 0}))},
         {"limited", is_limited && lower < upper ? "true" : "false"},
         {"range", join_numbers({lower, upper})},
         {"damping", format_number(joint.dynamics ? joint.dynamics->damping.value_or(0) : 0)},
         {"frictionloss",
          format_number(joint.dynamics ? joint.dynamics->friction.value_or(0) : 0)}});
    add_start(format_number(start_position(model, joint, linked(i).joint_positions)));
    if (joint.mimic && joint.mimic->joint && joint.name) followers_.emplace_back(i, &joint);
    return true;
  }

  void add_geoms(std::size_t i, const LinkedModel& model, const urdf::Link& link) {
    const FlatModel& flat_model = scene_.flat.models[*flat(i).model];
    for (const urdf::Visual& visual : link.visuals) {
      if (const auto geometry = to_flat(visual.geometry, flat_model)) {
        add_geom("visual", urdf::to_pose(visual.origin), *geometry, color_of(visual, *model.robot));
      }
    }
    for (const urdf::Collision& collision : link.collisions) {
      if (const auto geometry = to_flat(collision.geometry, flat_model)) {
        add_geom("collision", urdf::to_pose(collision.origin), *geometry, std::nullopt);
      }
    }
  }

  /// Type and size attributes of a geom; none for what is no geom of MuJoCo's or is reported.
  std::optional<std::pair<std::string, std::string>> geom_of(const FlatGeometry& geometry) const {
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

  void add_geom(const std::string& geom_class, const Pose& pose, const FlatGeometry& geometry,
                const std::optional<Rgba>& color) {
    const std::string position = join_numbers(pose.position);
    const std::string rotation = quaternion_text(pose.orientation);
    const Rgba c = color.value_or(Rgba{0.5, 0.5, 0.5, 1});
    const std::string rgba = join_numbers({c[0], c[1], c[2], c[3]});
    if (const auto* mesh = std::get_if<FlatMesh>(&geometry)) {
      const auto known = meshes_.find(mesh_key(*mesh));
      if (known == meshes_.end()) return;
      xml_.empty("geom", {{"class", geom_class},
                          {"type", "mesh"},
                          {"mesh", known->second},
                          {"pos", position},
                          {"quat", rotation},
                          {"rgba", rgba}});
    } else if (const auto geom = geom_of(geometry)) {
      xml_.empty("geom", {{"class", geom_class},
                          {"type", geom->first},
                          {"size", geom->second},
                          {"pos", position},
                          {"quat", rotation},
                          {"rgba", rgba}});
    }
  }

  void add_solid(std::size_t i) {
    const FlatInstance& instance = flat(i);
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
      xml_.empty("joint", {{"name", name(i, "free")}, {"type", "free"}});
      add_start(join_numbers(instance.X_WE->position) + " " +
                quaternion_text(instance.X_WE->orientation));
      LinkInertial mass = solid_mass(instance.shapes.front().geometry, mass_of(instance));
      mass.X_LC = instance.shapes.front().X_ES;
      xml_.empty("inertial", {{"pos", join_numbers(mass.X_LC.position)},
                              {"mass", format_number(mass.mass)},
                              {"fullinertia", full_inertia(mass)}});
    }
    // Planes stand in the world body only, so that what does not move has no body.
    for (const FlatShape& shape : instance.shapes) {
      add_geom("collision", moves ? shape.X_ES : *instance.X_WE * shape.X_ES, shape.geometry,
               shape.color);
    }
    if (moves) xml_.close();
  }

  void add_equalities() {
    if (followers_.empty()) return;
    xml_.open("equality");
    for (const auto& [i, joint] : followers_) {
      xml_.empty("joint",
                 {{"joint1", name(i, *joint->name)},
                  {"joint2", name(i, *joint->mimic->joint)},
                  {"polycoef", join_numbers({joint->mimic->offset.value_or(0),
                                             joint->mimic->multiplier.value_or(1), 0, 0, 0})}});
    }
    xml_.close();
  }

  const SceneExport& scene_;
  SceneLosses losses_;
  std::vector<bool> is_top_level_;
  std::map<PlaceOfLink, std::vector<std::size_t>> children_;
  std::map<std::string, std::string> meshes_;  ///< mesh_key -> name
  std::set<std::size_t> heightmaps_;           ///< instances whose hfield is declared
  std::set<const urdf::Joint*> reported_;
  std::vector<std::pair<std::size_t, const urdf::Joint*>> followers_;
  std::string start_;  ///< qpos
  LinkFrames frames_;
  XmlText xml_;
};

}  // namespace

extern constinit const SceneFormat scene_mjcf{
    .name = "mjcf",
    .help = "a MuJoCo world, for version 2.2 and later",
    .write = [](const SceneExport& scene) { return MjcfWriter(scene).run(); }};

}  // namespace smurf
