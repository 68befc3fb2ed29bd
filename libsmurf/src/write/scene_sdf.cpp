// SPDX-License-Identifier: BSD-3-Clause
// SDFormat worlds for Gazebo. Entities that are fixed to each other share one outer model, since
// SDF 1.9 has no joints between models. Joint poses are baked into the poses of the links and the
// limits shifted along, since SDF has no initial joint positions.
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "base/text/unique_names.hpp"
#include "write/losses/scene_losses.hpp"
#include "write/parts/annotated_colors.hpp"
#include "write/parts/body_inertia.hpp"
#include "write/parts/loops.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/sdf/sdf_model.hpp"
#include "write/sdf/sdf_names.hpp"
#include "write/text/xml_text.hpp"

namespace smurf::scene_sdf_file {
namespace {

class SdfWriter {
 public:
  SdfWriter(const SceneExport& scene, bool is_old)
      : scene_(scene),
        is_old_(is_old),
        losses_(scene, is_old ? SceneColumn::sdf16 : SceneColumn::sdf, is_old ? "SDF 1.6" : "SDF"),
        names_(sdf_names(scene.flat)) {}

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
  const FlatInstance& flat(std::size_t i) const { return scene_.flat.instances[i]; }
  const LinkedModel* robot_of(std::size_t i) const { return smurf::robot_of(scene_.scene, i); }
  bool is_written(std::size_t i) const {
    return flat(i).X_WE && (robot_of(i) != nullptr || !flat(i).shapes.empty());
  }

  const std::vector<std::string>& links_of(const LinkedModel& model) const {
    const auto [known, is_new] = links_.try_emplace(&model);
    if (is_new) known->second = sdf_names(model);
    return known->second;
  }
  /// Facts about a model, computed once.
  const SdfModel& parts_of(const LinkedModel& model) {
    auto& known = models_[&model];
    if (known) return *known;
    known = std::make_unique<SdfModel>(model, scene_.sources);
    for (const auto& [span, name] : known->lost_contacts()) {
      losses_.note(kLostContacts, span, name);
    }
    return *known;
  }
  const std::string& root_name(const LinkedModel& model) const {
    return links_of(model)[to_size(model.tree.roots.front())];
  }

  void add_pose(const Pose& pose) { add_sdf_pose(xml_, pose, is_old_); }

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
    if (is_new) known->second = sdf_bodies(*parent, refers(*parent));
    const std::vector<std::size_t>& bodies = known->second;
    add_fixed_joint("anchor_of_" + names_[i],
                    names_[other] + "::" + links_of(*parent)[bodies[*link]],
                    names_[i] + "::" + root_name(i));
  }

  std::string root_name(std::size_t i) const {
    const LinkedModel* model = robot_of(i);
    return model != nullptr ? root_name(*model) : "link";
  }

  void add_fixed_joint(const std::string& name, const std::string& parent,
                       const std::string& child) {
    xml_.open("joint", {{"name", name}, {"type", "fixed"}});
    xml_.leaf("parent", parent);
    xml_.leaf("child", child);
    xml_.close();
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
    const std::vector<std::size_t>& bodies = parts_of(model).bodies;
    std::vector<std::vector<std::size_t>> parts(bodies.size());
    for (const LinkIndex link : model.tree.order) {
      const std::size_t at = to_size(link);
      if (X_EL[at]) parts[bodies[at]].push_back(at);
    }
    for (const LinkIndex link : model.tree.order) {
      const std::size_t at = to_size(link);
      if (!X_EL[at]) continue;
      if (bodies[at] == at) {
        add_link(i, model, at, parts[at], X_EL);
      } else if (!is_old_) {
        xml_.open("frame",
                  {{"name", links_of(model)[at]}, {"attached_to", links_of(model)[bodies[at]]}});
        add_pose(inverse(*X_EL[bodies[at]]) * *X_EL[at]);
        xml_.close();
      }
    }
    for (const LinkIndex link : model.tree.order) {
      const std::size_t at = to_size(link);
      const auto& above = model.tree.parent_joint[at];
      if (!above || bodies[at] != at || !X_EL[at]) continue;
      const std::size_t parent = bodies[to_size(*model.tree.joint_parent[to_size(*above)])];
      add_joint(i, model, model.joint(*above), links_of(model)[parent], links_of(model)[at]);
    }
    for (const Loop& loop : loops_of(model)) {
      if (loop.joint != nullptr) add_loop(i, model, loop);
    }
    if (flat(i).anchor.kind == Attachment::Kind::world) {
      add_fixed_joint("anchor_to_world", "world", root_name(i));
    }
    parts_of(model).gazebo.add_to_model(xml_);
    xml_.close();
  }

  void add_link(std::size_t i, const LinkedModel& model, std::size_t body,
                const std::vector<std::size_t>& parts,
                const std::vector<std::optional<Pose>>& X_EL) {
    xml_.open("link", {{"name", links_of(model)[body]}});
    add_pose(*X_EL[body]);
    const urdf::Link& whole = model.robot->links[body];
    const ChosenMass mass = link_mass(model, whole);
    if (!mass.chosen.empty()) losses_.note(mass.chosen, whole.span, link_name(model, body));
    const BodyInertia inertia = body_inertia(mass.mass, 0, 0);
    if (inertia.is_changed) losses_.note(kRefusedInertias, whole.span, link_name(model, body));
    add_sdf_inertial(xml_, inertia.mass, is_old_);
    UniqueNames sensors;
    for (const std::size_t part : parts) {
      const Pose X_BL = inverse(*X_EL[body]) * *X_EL[part];
      add_shapes(model, scene_.flat.models[*flat(i).model], part, X_BL);
      const std::string frame = part == body || is_old_ ? "" : links_of(model)[part];
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

  void add_joint(std::size_t i, const LinkedModel& model, const urdf::Joint& joint,
                 const std::string& parent, const std::string& child) {
    using enum urdf::JointType;
    if (joint.type == floating) return;  // bodies of one model without a joint between them
    if (joint.type == planar || joint.type == unknown) simplify(joint, "fixed");
    if (joint.mimic) {
      simplify(joint, is_old_ ? "free to move, since SDF 1.6 has no `mimic`,"
                              : "free to move, since Gazebo before Harmonic ignores `mimic`,");
    }
    const std::string type = joint.type == prismatic ? "prismatic"
                             : joint.has_one_axis()  ? "revolute"
                                                     : "fixed";
    const std::string name = joint.name ? joint_name(model, joint) : child + "_joint";
    xml_.open("joint", {{"name", name}, {"type", type}});
    xml_.leaf("parent", parent);
    xml_.leaf("child", child);
    if (joint.has_one_axis()) add_axis(i, model, joint, start_of(i, model, joint));
    UniqueNames sensors;
    parts_of(model).add_to_joint(xml_, joint, is_old_, sensors);
    xml_.close();
  }

  /// A joint to a second parent; its zero is at the start, as that of others.
  void add_loop(std::size_t i, const LinkedModel& model, const Loop& loop) {
    const std::vector<std::optional<Pose>>& X_EL = frames_of(scene_, i, frames_);
    const std::vector<std::size_t>& bodies = parts_of(model).bodies;
    const std::size_t child = bodies[loop.child];
    const bool is_hinge = loop.kind == LoopKind::hinge;
    const LoopGap gap = gap_of(loop, X_EL);
    xml_.open("joint", {{"name", joint_name(model, *loop.joint)},
                        {"type", is_hinge ? "revolute" : "fixed"}});
    add_pose(inverse(*X_EL[child]) * *X_EL[loop.parent] * loop.X_PJ *
             Pose{{}, from_axis_angle(loop.axis, gap.turn)});
    xml_.leaf("parent", links_of(model)[bodies[loop.parent]]);
    xml_.leaf("child", links_of(model)[child]);
    if (is_hinge) add_axis(i, model, *loop.joint, gap.turn);
    xml_.close();
  }

  /// Links and joints share one name space in SDF, but not in a URDF.
  static std::string joint_name(const LinkedModel& model, const urdf::Joint& joint) {
    std::string name = sdf_name(*joint.name);
    const auto is_taken = [&](const std::string& one) {
      return model.link_names.contains(one) ||
             (one != *joint.name && model.joint_names.contains(one));
    };
    while (is_taken(name)) name += "_joint";
    return name;
  }

  void simplify(const urdf::Joint& joint, std::string_view written_as) {
    if (reported_.insert({static_cast<std::uint32_t>(joint.span.source), joint.span.begin})
            .second) {
      losses_.joint(joint, written_as);
    }
  }

  double start_of(std::size_t i, const LinkedModel& model, const urdf::Joint& joint) const {
    return start_position(model, joint, scene_.joint_positions(i));
  }

  void add_axis(std::size_t i, const LinkedModel& model, const urdf::Joint& joint, double start) {
    xml_.open("axis");
    xml_.leaf("xyz", join_numbers(losses_.axis_of(joint)));
    xml_.open("limit");
    constexpr double kUnlimited = 1e16;  // SDF's default
    if (joint.type != urdf::JointType::continuous && joint.limit) {
      xml_.leaf("lower", joint.limit->lower.value_or(0) - start);
      xml_.leaf("upper", joint.limit->upper.value_or(0) - start);
    } else {
      xml_.leaf("lower", -kUnlimited);
      xml_.leaf("upper", kUnlimited);
    }
    if (joint.limit && joint.limit->effort) xml_.leaf("effort", *joint.limit->effort);
    if (joint.limit && joint.limit->velocity) xml_.leaf("velocity", *joint.limit->velocity);
    xml_.close();
    if (!is_old_ && joint.mimic) add_mimic(i, model, joint);
    const GazeboElements& gazebo = parts_of(model).gazebo;
    if (joint.dynamics || (joint.name && gazebo.has_spring(*joint.name))) {
      xml_.open("dynamics");
      xml_.leaf("damping", joint.dynamics ? joint.dynamics->damping.value_or(0) : 0);
      xml_.leaf("friction", joint.dynamics ? joint.dynamics->friction.value_or(0) : 0);
      if (joint.name) gazebo.add_to_dynamics(xml_, *joint.name);
      xml_.close();
    }
    xml_.close();
  }

  /// Writes the mimic element of SDF 1.11, which older libraries ignore. Positions are relative to
  /// the start positions of the joints.
  void add_mimic(std::size_t i, const LinkedModel& model, const urdf::Joint& joint) {
    if (!joint.mimic->joint) return;
    const auto leader = model.joint_names.find(*joint.mimic->joint);
    if (!leader || !model.robot->joints[*leader].has_one_axis()) return;
    const urdf::Joint& leading = model.robot->joints[*leader];
    if (&leading == &joint) return;
    const double multiplier = joint.mimic->multiplier.value_or(1);
    const double offset = joint.mimic->offset.value_or(0) +
                          multiplier * start_of(i, model, leading) - start_of(i, model, joint);
    xml_.open("mimic", {{"joint", joint_name(model, leading)}});
    xml_.leaf("multiplier", multiplier);
    xml_.leaf("offset", offset);
    xml_.leaf("reference", 0);
    xml_.close();
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

  const SceneExport& scene_;
  bool is_old_;
  SceneLosses losses_;
  std::vector<std::string> names_;
  mutable std::map<const LinkedModel*, std::vector<std::string>> links_;  ///< names, by model
  std::map<const LinkedModel*, std::unique_ptr<SdfModel>> models_;
  LinkFrames frames_;
  AnnotatedColors colors_;
  /// By model with anchored entities: the bodies of its links.
  std::map<const LinkedModel*, std::vector<std::size_t>> bodies_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> reported_;
  XmlText xml_{scene_.most_bytes};
};

}  // namespace

extern constinit const SceneFormat scene_sdf{
    .name = "sdf",
    .help = "an SDFormat 1.9 world, for Gazebo",
    .write = [](const SceneExport& scene) { return SdfWriter(scene, false).run(); },
    .has_reference_form = true,
    .has_ground = true,
    .repeats_models = true,
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
    .fixes_world_roots = true,
    .repeated_parts = sdf_parts};

}  // namespace smurf::scene_sdf16_file
