// SPDX-License-Identifier: BSD-3-Clause
// SDFormat worlds for Gazebo. Entities that are fixed to each other share one outer model, since
// SDF 1.9 has no joints between models.
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/unique_names.hpp"
#include "write/parts/annotated_colors.hpp"
#include "write/parts/body_inertia.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/sdf/sdf_joints.hpp"
#include "write/sdf/sdf_names.hpp"

namespace smurf::scene_sdf_file {
namespace {

class SdfWriter : SdfJoints {
 public:
  SdfWriter(const SceneExport& scene, bool is_old)
      : SdfJoints(scene, is_old), names_(sdf_names(scene.flat)) {}

  std::string run() {
    xml_.open("sdf", {{"version", is_old_ ? "1.6" : "1.9"}});
    xml_.open("world", {{"name", "scene"}});
    add_physics();
    add_lights();
    if (scene_.ground) add_ground();
    add_groups();
    if (!is_old_) add_sdf_systems(xml_, scene_.scene);
    check_heightmaps();
    losses_.table();
    losses_.files_in_archives();
    return xml_.finish();
  }

 private:
  bool is_written(std::size_t i) const {
    return flat(i).X_WE && (robot_of(i) != nullptr || !flat(i).shapes.empty());
  }

  /// Of the body that contains the root.
  const std::string& root_name(const LinkedModel& model) {
    const std::size_t root = to_size(model.tree.roots.front());
    return links_of(model)[refers(model) ? root : parts_of(model).tree.bodies[root]];
  }

  void check_heightmaps() {
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      for (const FlatShape& shape : flat(i).shapes) {
        const auto* map = std::get_if<FlatHeightmap>(&shape.geometry);
        if (map == nullptr || !flat(i).X_WE || is_heightmap_of_gazebo(scene_.meshes, *map))
          continue;
        losses_.note(kOddHeights, place_of(*flat(i).entity), flat(i).path);
      }
    }
  }

  /// Defaults are written as well, so that all simulators read the same world.
  void add_physics() {
    const FlatPhysics& physics = scene_.flat.physics;
    xml_.leaf("gravity", join_numbers(physics.gravity.value_or(kUsualGravity)));
    xml_.open("physics", {{"name", "smurf"}, {"type", "ode"}});
    xml_.leaf("max_step_size", physics.step_size.value_or(kUsualStep));
    xml_.leaf("real_time_factor", 1);
    if (physics.cfm || physics.erp) {
      xml_.open("ode");
      xml_.open("constraints");
      if (physics.cfm) xml_.leaf("cfm", *physics.cfm);
      if (physics.erp) xml_.leaf("erp", *physics.erp);
      xml_.close();
      xml_.close();
    }
    xml_.close();
  }

  void add_lights() {
    UniqueNames unique;
    for (const std::string& name : names_) unique.take(name);
    for (const Light* light : world_lights(scene_)) {
      add_sdf_light(xml_, *light, unique.add(light->name.value_or("light")), is_old_);
    }
  }

  void add_ground() {
    UniqueNames unique;
    for (const std::string& name : names_) unique.take(name);
    xml_.open("model", {{"name", unique.add("ground")}});
    xml_.leaf("static", "true");
    xml_.open("link", {{"name", "link"}});
    for (const std::string_view element : {"visual", "collision"}) {
      open_shape(element, std::string(element), Pose(), FlatPlane{kGroundSize, kGroundSize});
      xml_.close();
    }
    xml_.close();
    xml_.close();
  }

  void add_groups() {
    const std::vector<std::size_t> ends = anchor_groups(scene_.flat);
    std::map<std::size_t, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (is_written(i)) {
        groups[ends[i]].push_back(i);
      } else if (flat(i).X_WE) {
        losses_.entity(i, "SDF knows no entities of type `" + flat(i).type + "`");
      }
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto group = groups.find(ends[i]);
      if (group == groups.end() || group->second.front() != i) continue;
      if (group->second.size() == 1) {
        add_model(i);
        if (flat(i).anchor.kind == Attachment::Kind::link) {
          losses_.anchor(i, "`" + flat(i).anchor.instance + "` is not written either");
        }
        continue;
      }
      xml_.open("model", {{"name", names_[ends[i]] + "__and_what_is_fixed_to_it"}});
      for (const std::size_t member : group->second) add_model(member);
      for (const std::size_t member : group->second) add_anchor(member);
      xml_.close();
    }
  }

  /// Between two models of a group.
  void add_anchor(std::size_t i) {
    if (flat(i).anchor.kind != Attachment::Kind::link) return;
    const std::size_t other = flat(i).anchor.index;
    const LinkedModel* parent = robot_of(other);
    if (parent == nullptr || !is_written(other)) {
      losses_.anchor(i, "`" + flat(other).path + "` is not a model with links");
      return;
    }
    const auto link = parent->link_names.find(flat(i).anchor.link);
    if (!link) return;
    const auto [known, is_new] = bodies_.try_emplace(parent);
    if (is_new)
      known->second = refers(*parent) ? sdf_bodies(*parent, true) : parts_of(*parent).tree.bodies;
    const std::vector<std::size_t>& bodies = known->second;
    add_fixed_joint("anchor_of_" + names_[i],
                    names_[other] + "::" + links_of(*parent)[bodies[*link]],
                    names_[i] + "::" + root_name(i));
  }

  std::string root_name(std::size_t i) {
    const LinkedModel* model = robot_of(i);
    return model != nullptr ? root_name(*model) : "link";
  }

  void add_model(std::size_t i) {
    const LinkedModel* model = robot_of(i);
    if (model == nullptr) {
      add_solid(i);
    } else if (refers(*model)) {
      add_include(i, *model);
    } else {
      add_robot(i, *model);
    }
  }

  /// libsdformat drops a URDF whose root link has no mass, so such a model is written out.
  bool refers(const LinkedModel& model) const {
    return scene_.form == SceneForm::reference && !is_old_ &&
           inertial_of(model.link(model.tree.roots.front())).has_value();
  }

  void add_include(std::size_t i, const LinkedModel& model) {
    const std::string uri = scene_.flat.models[*flat(i).model].urdf;
    losses_.joint_pose(i, "an included URDF has no place for it; --form expand does");
    const bool is_fixed = flat(i).anchor.kind == Attachment::Kind::world;
    if (is_fixed) {
      xml_.open("model", {{"name", names_[i]}});
      add_pose(*flat(i).X_WE);
      xml_.open("include", {{"merge", "true"}});
      xml_.leaf("uri", uri);
      xml_.close();
      add_fixed_joint("anchor_to_world", "world", root_name(model));
    } else {
      xml_.open("include");
      xml_.leaf("name", names_[i]);
      xml_.leaf("uri", uri);
      add_pose(*flat(i).X_WE);
    }
    xml_.close();
  }

  void add_robot(std::size_t i, const LinkedModel& model) {
    xml_.open("model", {{"name", names_[i]}});
    add_pose(*flat(i).X_WE);
    const std::vector<std::optional<Pose>>& X_EL = frames_of(scene_, i, frames_);
    const SdfTree& tree = parts_of(model).tree;
    const std::size_t root = to_size(model.tree.roots.front());
    const bool is_fixed = flat(i).anchor.kind == Attachment::Kind::world;
    const bool has_world = tree.has_world && is_fixed;
    std::vector<std::vector<std::size_t>> parts(tree.bodies.size());
    for (const LinkIndex link : model.tree.order) {
      const std::size_t at = to_size(link);
      const bool is_written = tree.bodies[at] != SdfTree::kNoBody && (at != root || !has_world);
      if (X_EL[at] && is_written) parts[tree.bodies[at]].push_back(at);
    }
    Scopes scopes;
    for (const LinkIndex link : model.tree.order) {
      const std::size_t at = to_size(link);
      const std::size_t body = tree.bodies[at];
      const bool is_lost = body == SdfTree::kNoBody || !X_EL[at] || !X_EL[body];
      if (is_lost || (at == root && has_world) || (body != at && is_old_)) continue;
      scope_in(scopes, sdf_scope(links_of(model)[at])).links.push_back(at);
    }
    for (const SdfJoint& joint : tree.joints) {
      if (!X_EL[joint.frame] || !X_EL[tree.bodies[joint.frame]]) continue;
      const bool is_in_world = joint.parent == root && has_world;
      const std::string& child = links_of(model)[tree.bodies[joint.frame]];
      std::string parent = is_in_world ? "world" : links_of(model)[tree.bodies[joint.parent]];
      const std::string name = joint.joint->name.value_or({});
      Scope& scope = scope_in(scopes, sdf_joint_scope(name, parent, child));
      scope.joints.emplace_back(&joint, std::move(parent));
    }
    add_scope(i, model, scopes, {}, parts, X_EL);
    for (const Loop& loop : loops_of(model)) {
      if (loop.joint != nullptr) add_loop(i, model, loop);
    }
    if (is_fixed && !has_world) {
      add_fixed_joint("anchor_to_world", "world", root_name(model));
    }
    add_own_contacts();
    parts_of(model).gazebo.add_to_model(xml_);
    if (!is_old_) add_controllers(model);
    xml_.close();
  }

  /// Links that a joint connects never touch in SDF.
  void add_own_contacts() {
    const SelfCollision choice = scene_.contacts.choice;
    if (choice == SelfCollision::as_usual) return;
    xml_.leaf("self_collide", choice == SelfCollision::none ? "false" : "true");
  }

  /// What is in a model, and not in the models in it.
  struct Scope {
    std::vector<std::size_t> links;
    std::vector<std::pair<const SdfJoint*, std::string>> joints;  ///< with the name of the parent
    std::vector<std::string> models;
  };
  using Scopes = std::map<std::string, Scope, std::less<>>;

  static Scope& scope_in(Scopes& scopes, std::string_view name) {
    const auto found = scopes.find(name);
    if (found != scopes.end()) return found->second;
    if (!name.empty()) scope_in(scopes, sdf_scope(name)).models.emplace_back(name);
    return scopes[std::string(name)];
  }

  /// The frames of nested models are that of the outermost one.
  void add_scope(std::size_t i, const LinkedModel& model, const Scopes& scopes,
                 std::string_view name, const std::vector<std::vector<std::size_t>>& parts,
                 const std::vector<std::optional<Pose>>& X_EL) {
    const auto found = scopes.find(name);
    if (found == scopes.end()) return;
    for (const std::size_t link : found->second.links) {
      const std::size_t body = parts_of(model).tree.bodies[link];
      if (body == link) add_link(i, model, link, parts[link], X_EL);
      if (body != link) add_frame(model, link, body, X_EL);
    }
    for (const auto& [joint, parent] : found->second.joints) {
      add_joint(i, model, *joint, parent, name);
    }
    for (const std::string& inner : found->second.models) {
      xml_.open("model", {{"name", std::string(sdf_local(inner, name))}});
      add_scope(i, model, scopes, inner, parts, X_EL);
      xml_.close();
    }
  }

  static std::string local_name(const std::string& name) {
    return std::string(sdf_local(name, sdf_scope(name)));
  }

  void add_frame(const LinkedModel& model, std::size_t part, std::size_t body,
                 const std::vector<std::optional<Pose>>& X_EL) {
    xml_.open("frame", {{"name", local_name(links_of(model)[part])},
                        {"attached_to", local_name(links_of(model)[body])}});
    add_pose(inverse(*X_EL[body]) * *X_EL[part]);
    xml_.close();
  }

  void add_link(std::size_t i, const LinkedModel& model, std::size_t body,
                const std::vector<std::size_t>& parts,
                const std::vector<std::optional<Pose>>& X_EL) {
    xml_.open("link", {{"name", local_name(links_of(model)[body])}});
    add_pose(*X_EL[body]);
    const urdf::Link& whole = model.robot->links[body];
    const ChosenMass mass = link_mass(scene_, model, whole);
    if (!mass.chosen.empty()) losses_.note(mass.chosen, whole.span, link_name(model, body));
    const BodyInertia inertia = body_inertia(mass.mass, 0, 0);
    if (inertia.is_changed) losses_.note(kRefusedInertias, whole.span, link_name(model, body));
    add_sdf_inertial(xml_, inertia.mass, is_old_);
    UniqueNames sensors;
    for (const std::size_t part : parts) {
      const Pose X_BL = inverse(*X_EL[body]) * *X_EL[part];
      add_shapes(model, scene_.flat.models[*flat(i).model], part, X_BL);
      const std::string frame = part == body || is_old_ ? "" : local_name(links_of(model)[part]);
      parts_of(model).add_to_link(xml_, part, frame, X_BL, is_old_, sensors);
    }
    xml_.close();
  }

  void add_shapes(const LinkedModel& model, const FlatModel& flat_model, std::size_t part,
                  const Pose& X_BL) {
    const urdf::Link& link = model.robot->links[part];
    const SdfShapeNames& names = parts_of(model).shape_names;
    const GazeboElements& gazebo = parts_of(model).gazebo;
    const std::string_view link_name = link.name ? std::string_view(*link.name) : "";
    for (const urdf::Visual& visual : link.visuals) {
      if (xml_.is_full()) return;
      const auto geometry = to_flat(visual.geometry, flat_model);
      if (!geometry || !can_say(*geometry, visual.span)) continue;
      open_shape("visual", names.visuals.at(&visual), X_BL * urdf::to_pose(visual.origin),
                 *geometry);
      if (!gazebo.has_own_material(link_name)) {
        AnnotatedLooks::Look look = colors_.look_of(visual, model, flat_model);
        if (look.color) look.color = as_libsdformat_has(*look.color);
        if (is_old_) look.texture.reset();
        add_sdf_material(xml_, {look.color, look.texture, gazebo.material(link_name)});
      }
      if (!gazebo.empty()) gazebo.add_to_visual(xml_, link_name);
      xml_.close();
    }
    for (const urdf::Collision& collision : link.collisions) {
      if (xml_.is_full()) return;
      const auto geometry = to_flat(collision.geometry, flat_model);
      if (!geometry || !can_say(*geometry, collision.span)) continue;
      open_shape("collision", names.collisions.at(&collision),
                 X_BL * urdf::to_pose(collision.origin), *geometry);
      const Contacts contacts = is_old_ ? Contacts() : parts_of(model).contacts.of(collision, link);
      add_sdf_surface(xml_, contacts, gazebo.empty() ? nullptr : &gazebo, link_name);
      if (!gazebo.empty()) gazebo.add_to_collision(xml_, link_name);
      xml_.close();
    }
  }

  bool can_say(const FlatGeometry& geometry, Span span) {
    if (!is_old_ || !std::holds_alternative<FlatCapsule>(geometry)) return true;
    if (reported_.insert({static_cast<std::uint32_t>(span.source), span.begin}).second) {
      losses_.shape(span, "a capsule");
    }
    return false;
  }

  void open_shape(std::string_view element, const std::string& name, const Pose& pose,
                  const FlatGeometry& geometry) {
    xml_.open(element, {{"name", name}});
    add_pose(pose);
    add_sdf_geometry(xml_, geometry);
  }

  void add_solid(std::size_t i) {
    const FlatInstance& instance = flat(i);
    xml_.open("model", {{"name", names_[i]}});
    if (!is_movable(instance)) xml_.leaf("static", "true");
    add_pose(*instance.X_WE);
    xml_.open("link", {{"name", "link"}});
    if (is_movable(instance)) {
      LinkInertial mass = solid_mass(instance.shapes.front().geometry, mass_of(instance));
      mass.X_LC = instance.shapes.front().X_ES;
      add_sdf_inertial(xml_, mass, is_old_);
    }
    int number = 0;
    for (const FlatShape& shape : instance.shapes) {
      const Span place = place_of(*flat(i).entity);
      if (!can_say(shape.geometry, place)) continue;
      open_shape("visual", "visual_" + std::to_string(number), shape.X_ES, shape.geometry);
      add_sdf_material(xml_, {.color = shape.color, .texture = {}, .script = {}});
      xml_.close();
      open_shape("collision", "collision_" + std::to_string(number++), shape.X_ES, shape.geometry);
      if (!is_old_) add_sdf_surface(xml_, contacts_of(instance.properties), nullptr, {});
      xml_.close();
    }
    xml_.close();
    xml_.close();
  }

  std::vector<std::string> names_;
  AnnotatedColors colors_;
  /// By model with anchored entities: the bodies of its links.
  std::map<const LinkedModel*, std::vector<std::size_t>> bodies_;
};

}  // namespace

extern constinit const SceneFormat scene_sdf{
    .name = "sdf",
    .help = "an SDFormat 1.9 world, for Gazebo",
    .write = [](const SceneExport& scene) { return SdfWriter(scene, false).run(); },
    .has_reference_form = true,
    .has_ground = true,
    .repeats_models = true,
    .has_motors = true,
    .has_contacts = true,
    .has_bitmasks = true,
    .has_collisions = true,
    .fixes_world_roots = true,
    .repeated_parts = sdf_parts};

}  // namespace smurf::scene_sdf_file

namespace smurf::scene_sdf16_file {

extern constinit const SceneFormat scene_sdf16{
    .name = "sdf1.6",
    .help = "an SDFormat 1.6 world, for older readers",
    .write = [](const SceneExport& scene) { return scene_sdf_file::SdfWriter(scene, true).run(); },
    .has_ground = true,
    .repeats_models = true,
    .has_contacts = true,
    .has_collisions = true,
    .fixes_world_roots = true,
    .repeated_parts = sdf_parts};

}  // namespace smurf::scene_sdf16_file
