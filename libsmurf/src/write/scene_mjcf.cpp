// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo: bodies are nested like the kinematic trees, anchored entities are inside the link that
// holds them, and the keyframe `initial` contains the start position of every joint.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/unique_names.hpp"
#include "write/mjcf/mjcf_attach.hpp"
#include "write/mjcf/mjcf_excludes.hpp"
#include "write/mjcf/mjcf_loops.hpp"
#include "write/parts/annotated_colors.hpp"
#include "write/parts/body_inertia.hpp"
#include "write/parts/joint_chain.hpp"

namespace smurf::scene_mjcf_file {
namespace {

class MjcfWriter : MjcfLoops {
 public:
  using MjcfLoops::MjcfLoops;

  std::string run() {
    find_children();
    xml_.open("mujoco", {{"model", "scene"}});
    add_settings();
    add_assets();
    xml_.open("worldbody");
    add_lights();
    if (scene_.ground) {
      const double half = kGroundSize / 2;
      xml_.empty("geom", {{"class", "solid"},
                          {"type", "plane"},
                          {"size", join_numbers({half, half, 1})},
                          {"name", geom_names_.add("ground")}});
    }
    for (std::size_t i = 0; i < count(); ++i) {
      if (is_top_level_[i] && flat(i).X_WE) add_top_level(i);
    }
    xml_.close();
    add_excludes();
    add_equalities();
    add_actuators();
    add_sensors();
    add_keyframes();
    return finish();
  }

 private:
  using PlaceOfLink = std::pair<std::size_t, std::size_t>;  ///< instance, link

  /// The instances that are anchored to each link. A cycle of anchors is broken at its end.
  void find_children() {
    const std::vector<std::size_t> ends = anchor_groups(scene_.flat);
    is_top_level_.assign(count(), true);
    for (std::size_t i = 0; i < count(); ++i) {
      const FlatAttachment& anchor = flat(i).anchor;
      if (anchor.kind != Attachment::Kind::link || !flat(i).X_WE || robot_of(i) == nullptr)
        continue;
      const std::size_t other = anchor.index;
      const std::optional<std::size_t> link = anchor_link(scene_, i);
      if (!link || !flat(other).X_WE || ends[i] == i) {
        losses_.anchor(i, "there is no link to attach it to");
        continue;
      }
      is_top_level_[i] = false;
      children_[{other, *link}].push_back(i);
    }
  }

  /// Meshes and heightmaps are declared once, and only those that MuJoCo can read.
  void add_assets() {
    xml_.open("asset");
    for (std::size_t m = 0; m < scene_.scene.models.size(); ++m) {
      const LinkedModel& model = scene_.scene.models[m];
      if (!model.robot) continue;
      existing_.clear();
      std::set<std::string> textures;
      for (const MeshReference& reference : model.meshes) {
        if (reference.exists) existing_.insert(reference.filename);
        if (is_texture_of_mujoco(reference))
          add_texture(reference, file_of(reference, m), textures);
      }
      for (const urdf::Link& link : model.robot->links) {
        for (const urdf::Visual& visual : link.visuals) {
          const auto texture = texture_of(visual, model, scene_.flat.models[m]);
          const bool has_look = texture || colors_.of(visual, model, scene_.flat.models[m]);
          add_mesh(m, visual.geometry, visual.span, !has_look);
          if (texture && textures.contains(*texture)) declare_texture(*texture);
        }
        for (const urdf::Collision& shape : link.collisions)
          add_mesh(m, shape.geometry, shape.span, false);
      }
    }
    add_meshes_of_entities();
    add_heightmaps();
    xml_.close();
  }

  void add_texture(const MeshReference& reference, const std::string& file,
                   std::set<std::string>& textures) {
    if (is_png(file)) {
      textures.insert(file);
    } else {
      losses_.shape(reference.span, "the texture " + quoted(file) + ", whose content is not PNG,");
    }
  }

  /// By the name that texture_of() returns.
  std::string file_of(const MeshReference& reference, std::size_t model) const {
    const auto& resources = scene_.flat.models[model].resources;
    const auto known = resources.find(reference.filename);
    return known != resources.end() ? known->second : std::string(reference.filename);
  }

  void declare_texture(const std::string& file) {
    const std::string name = "texture_" + std::to_string(textures_.size());
    if (!textures_.emplace(file, name).second) return;
    xml_.empty("texture", {{"name", name}, {"type", "2d"}, {"file", file}});
    xml_.empty("material", {{"name", name}, {"texture", name}});
  }

  void add_mesh(std::size_t model, const urdf::Geometry& geometry, Span span, bool in_colors) {
    const auto flat_geometry = to_flat(geometry, scene_.flat.models[model]);
    const auto* mesh = flat_geometry ? std::get_if<FlatMesh>(&*flat_geometry) : nullptr;
    if (mesh == nullptr) return;
    if (meshes_.name_of(*mesh) == nullptr) {
      const bool exists = existing_.contains(*std::get<urdf::Mesh>(geometry.shape).filename);
      const std::string reason = exists ? meshes_.declare(*mesh, span) : "is not there";
      if (!reason.empty()) return losses_.unseen_shape(span, *flat_geometry, reason);
    }
    if (in_colors) meshes_.declare_parts(*mesh, span);
  }

  void add_top_level(std::size_t i) {
    const LinkedModel* model = robot_of(i);
    if (model == nullptr) return add_solid(i);
    const std::size_t root = to_size(model->tree.roots.front());
    const bool is_free = flat(i).anchor.kind != Attachment::Kind::world;
    add_tree(i, root, *flat(i).X_WE, is_free ? name(i, "free") : "");
    while (!floating_.empty()) {
      const Floating body = std::move(floating_.back());
      floating_.pop_back();
      add_tree(body.instance, body.link, body.X_WL, body.joint);
    }
  }

  /// A link that is being written. The stack replaces recursion, because files determine the depth.
  struct Step {
    std::size_t instance = 0, link = 0;
    std::vector<PlaceOfLink> inside;
    std::size_t next = 0;
    WeldedBodies* welded = nullptr;
  };

  /// Writes a link and everything below it. Without a name of a free joint, the link is fixed.
  void add_tree(std::size_t top, std::size_t root, const Pose& X_WL,
                const std::string& free_joint) {
    std::vector<Step> stack;
    WeldedBodies* welded = excludes_.add_tree(free_joint.empty());
    open_body(top, root, X_WL, {}, free_joint, welded);
    stack.push_back({top, root, inside(top, root), 0, welded});
    while (!stack.empty()) {
      Step& step = stack.back();
      if (step.next == step.inside.size()) {
        xml_.close();
        stack.pop_back();
        continue;
      }
      const auto [instance, link] = step.inside[step.next++];
      WeldedBodies* outer = step.welded;
      if (instance != step.instance) {
        const Pose X_LE = pose_on_anchor(scene_, instance, frames_).value_or(*flat(instance).X_WE);
        open_body(instance, link, X_LE, {}, "", outer);
      } else if (floats_in_world(instance, link, *outer)) {
        continue;
      } else {
        const JointChain chain = joint_chain(*robot_of(instance), link, kept_of(instance));
        outer = open_link(instance, chain, outer);
        stack.push_back({instance, chain.link, inside(instance, chain.link), 0, outer});
        continue;
      }
      stack.push_back({instance, link, inside(instance, link), 0, outer});
    }
  }

  /// MuJoCo allows free joints in the world only, so such a link is written there later.
  bool floats_in_world(std::size_t i, std::size_t link, const WeldedBodies& outer) {
    const LinkedModel& model = *robot_of(i);
    const urdf::Joint& joint = model.joint(*model.tree.parent_joint[link]);
    if (joint.type != urdf::JointType::floating || !outer.is_world()) return false;
    const std::optional<Pose>& X_EL = frames_of(scene_, i, frames_)[link];
    if (!X_EL || !flat(i).X_WE) return false;
    floating_.push_back({i, link, *flat(i).X_WE * *X_EL, name(i, joint.name.value_or("free"))});
    return true;
  }

  /// Adds the links below a link, then the roots of entities anchored to it.
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

  const KeptParts& kept_of(std::size_t i) {
    const LinkedModel& model = *robot_of(i);
    const auto [known, is_new] = kept_.try_emplace(&model);
    if (is_new) known->second = kept_parts(model, scene_);
    return known->second;
  }

  /// Writes a body at the zero position of its joints; the keyframe moves it.
  WeldedBodies* open_link(std::size_t i, const JointChain& chain, WeldedBodies* outer) {
    for (const JointChain::Part& part : chain.parts) {
      if (part.joint->has_one_axis()) outer = excludes_.add_moving(i, *outer);
    }
    open_body(i, chain.link, chain.X_PB, chain.parts, "", outer);
    return outer;
  }

  void open_body(std::size_t i, std::size_t link, const Pose& pose,
                 const std::vector<JointChain::Part>& joints, const std::string& free_joint,
                 WeldedBodies* welded) {
    const LinkedModel& model = *robot_of(i);
    const std::string body = name(i, link_name(model, link));
    xml_.open("body", {{"name", body},
                       {"pos", join_numbers(pose.position)},
                       {"quat", quaternion_text(pose.orientation)}});
    bool moves = !free_joint.empty();
    if (moves) add_free_joint(free_joint, pose);
    for (const JointChain::Part& part : joints) moves = add_joint(i, model, part) || moves;
    const urdf::Link& written = model.robot->links[link];
    if (moves && (inertial_of(written) || !carries_mass(model, link))) {
      const ChosenMass mass = link_mass(scene_, model, written);
      if (!mass.chosen.empty()) losses_.note(mass.chosen, written.span, link_name(model, link));
      add_inertial(mass.mass, moves, written.span, link_name(model, link));
    } else if (const auto mass = inertial_of(written)) {
      add_inertial(*mass, moves, written.span, link_name(model, link));
    }
    if (add_geoms(i, model, written)) {
      welded->add(i, body);
      touching_.emplace(i, link);
    }
    add_mounts(i, link);
    add_loop_sites(i, link);
  }

  /// False if the joint does not move.
  bool add_joint(std::size_t i, const LinkedModel& model, const JointChain::Part& part) {
    const urdf::Joint& joint = *part.joint;
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
    const DriveGains gains = gains_of(i, joint);
    const auto& dynamics = joint.dynamics;
    std::vector<XmlText::Attribute> attributes{
        {"name", name(i, joint.name.value_or(""))},
        {"type", is_linear ? "slide" : "hinge"},
        {"axis", join_numbers(rotate(part.X_BJ.orientation, losses_.axis_of(joint)))},
        {"limited", is_limited && lower < upper ? "true" : "false"},
        {"range", join_numbers({lower, upper})},
        {"damping", format_number((dynamics ? dynamics->damping.value_or(0) : 0) + gains.damping)},
        {"frictionloss", format_number(dynamics ? dynamics->friction.value_or(0) : 0)}};
    if (const JointSpring* spring = spring_of(model, joint); spring && spring->stiffness != 0) {
      attributes.emplace_back("stiffness", format_number(spring->stiffness));
      attributes.emplace_back("springref", format_number(spring->reference));
    }
    if (part.X_BJ.position != Vector3{})
      attributes.emplace_back("pos", join_numbers(part.X_BJ.position));
    const double armature = gains.armature > 0 ? gains.armature : armature_of(model, joint);
    if (armature > 0) attributes.emplace_back("armature", format_number(armature));
    xml_.empty("joint", attributes);
    keys_.add_position(i, joint, start_of(i, joint));
    if (joint.mimic) add_follower(i, model, joint);
    return true;
  }

  /// MuJoCo refuses an equality for a joint that does not exist, and of a joint with itself.
  void add_follower(std::size_t i, const LinkedModel& model, const urdf::Joint& joint) {
    const auto leader =
        joint.mimic->joint ? model.joint_names.find(*joint.mimic->joint) : std::nullopt;
    if (leader && joint.name && model.robot->joints[*leader].has_one_axis() &&
        &model.robot->joints[*leader] != &joint) {
      followers_.emplace_back(i, &joint);
    } else if (reported_.insert(&joint).second) {
      losses_.joint(joint, "free to move, since its leader does not move,");
    }
  }

  /// Whether any of them can touch another body.
  bool add_geoms(std::size_t i, const LinkedModel& model, const urdf::Link& link) {
    const FlatModel& flat_model = scene_.flat.models[*flat(i).model];
    bool is_shown = false;
    for (const urdf::Visual& visual : link.visuals) {
      const auto geometry = to_flat(visual.geometry, flat_model);
      auto geom = geometry ? geom_of("visual", *geometry) : std::nullopt;
      if (geometry && !geom) note_empty(*geometry, visual.span, link);
      if (!geom) continue;
      is_shown = true;
      add_name(*geom, i, link, visual.name, "visual");
      std::optional<Rgba> color = colors_.of(visual, model, flat_model);
      const auto texture = texture_of(visual, model, flat_model);
      const auto* mesh = std::get_if<FlatMesh>(&*geometry);
      const auto* parts = color || texture || mesh == nullptr ? nullptr : meshes_.parts_of(*mesh);
      if (parts != nullptr && !parts->empty()) {
        add_parts(*geom, *parts, urdf::to_pose(visual.origin));
        continue;
      }
      if (const auto known = texture ? textures_.find(*texture) : textures_.end();
          known != textures_.end()) {
        geom->emplace_back("material", known->second);
        // The colour is multiplied by the texture.
        if (!color) color = Rgba{1, 1, 1, 1};
      }
      add_geom(std::move(*geom), urdf::to_pose(visual.origin), color, {});
    }
    bool can_touch = false;
    for (const urdf::Collision& collision : link.collisions) {
      const auto geometry = to_flat(collision.geometry, flat_model);
      auto geom = geometry ? geom_of(is_shown ? "collision" : "solid", *geometry) : std::nullopt;
      if (geometry && !geom) note_empty(*geometry, collision.span, link);
      if (!geom) continue;
      add_name(*geom, i, link, collision.name, "collision");
      add_geom(std::move(*geom), urdf::to_pose(collision.origin), std::nullopt,
               contacts_of(model).of(collision, link));
      can_touch = true;
    }
    return can_touch;
  }

  /// Writes a geom for each colour of a mesh file. Only the first one has the name of the visual.
  void add_parts(std::vector<XmlText::Attribute> geom, const std::vector<MjcfMeshes::Part>& parts,
                 const Pose& pose) {
    for (const MjcfMeshes::Part& part : parts) {
      for (XmlText::Attribute& attribute : geom) {
        if (attribute.first == "mesh") attribute.second = part.name;
      }
      add_geom(geom, pose, part.color, {});
      std::erase_if(geom, [](const auto& attribute) { return attribute.first == "name"; });
    }
  }

  /// Missing meshes were reported when they were declared.
  void note_empty(const FlatGeometry& geometry, Span span, const urdf::Link& link) {
    if (std::holds_alternative<FlatMesh>(geometry)) return;
    losses_.note(kEmptyShapes, span, link.name.value_or({}));
  }

  /// Visuals and collisions share one name space in MJCF, but not in a URDF. Names are those that
  /// libsdformat gives.
  void add_name(std::vector<XmlText::Attribute>& geom, std::size_t i, const urdf::Link& link,
                const Field<std::string>& written, std::string_view kind) {
    const std::string shape =
        written ? *written : link.name.value_or("link") + "_" + std::string(kind);
    geom.emplace_back("name", geom_names_.add(name(i, shape)));
  }

  const CollisionContacts& contacts_of(const LinkedModel& model) {
    return contacts_.try_emplace(&model, model).first->second;
  }

  void add_excludes() {
    std::set<std::pair<std::string, std::string>> done;
    bool is_open = false;
    const auto exclude = [&](const std::string& body, const std::string& other) {
      if (!done.insert(std::minmax(body, other)).second) return true;
      if (!std::exchange(is_open, true)) xml_.open("contact");
      xml_.empty("exclude", {{"body1", body}, {"body2", other}});
      return !xml_.is_full();
    };
    const SelfCollision choice = scene_.contacts.choice;
    if (choice == SelfCollision::none) {
      exclude_all(exclude);
    } else if (choice != SelfCollision::all) {
      excludes_.for_each(exclude);
    }
    for (std::size_t i = 0; i < count(); ++i) {
      if (robot_of(i) == nullptr || !flat(i).X_WE) continue;
      exclude_loop_ends(i, exclude);
      const auto pairs = scene_.contacts.left_out.find(robot_of(i));
      if (pairs == scene_.contacts.left_out.end()) continue;
      for (const auto& [a, b] : pairs->second) {
        if (!touching_.contains({i, a}) || !touching_.contains({i, b})) continue;
        exclude(name(i, link_name(*robot_of(i), a)), name(i, link_name(*robot_of(i), b)));
      }
    }
    if (is_open) xml_.close();
  }

  /// All pairs of bodies of an instance that can touch.
  void exclude_all(const auto& exclude) {
    for (auto one = touching_.begin(); one != touching_.end(); ++one) {
      for (auto other = std::next(one); other != touching_.end(); ++other) {
        if (other->first != one->first) break;
        const LinkedModel& model = *robot_of(one->first);
        if (!exclude(name(one->first, link_name(model, one->second)),
                     name(one->first, link_name(model, other->second)))) {
          return;
        }
      }
    }
  }

  void add_equalities() {
    std::vector<MjcfFollower> followers;
    for (const auto& [i, joint] : followers_) {
      followers.push_back({name(i, *joint->name), name(i, *joint->mimic->joint),
                           joint->mimic->offset.value_or(0), joint->mimic->multiplier.value_or(1)});
    }
    append_driven_followers(followers);
    std::vector<std::size_t> in_loops;
    for (std::size_t i = 0; i < count(); ++i) {
      if (flat(i).X_WE && has_loops(i)) in_loops.push_back(i);
    }
    if (followers.empty() && in_loops.empty()) return;
    xml_.open("equality");
    for (const std::size_t i : in_loops) add_loop_equalities(i);
    for (const MjcfFollower& follower : followers) {
      xml_.empty("joint",
                 {{"joint1", follower.joint},
                  {"joint2", follower.leader},
                  {"polycoef", join_numbers({follower.offset, follower.multiplier, 0, 0, 0})}});
    }
    xml_.close();
  }

  /// A link that a floating joint connects to the world.
  struct Floating {
    std::size_t instance = 0, link = 0;
    Pose X_WL;
    std::string joint;  ///< name
  };

  std::vector<bool> is_top_level_;
  std::vector<Floating> floating_;
  MjcfExcludes excludes_;
  std::map<const LinkedModel*, KeptParts> kept_;
  std::set<PlaceOfLink> touching_;  ///< links with a shape that can touch others
  std::map<PlaceOfLink, std::vector<std::size_t>> children_;
  std::map<const LinkedModel*, CollisionContacts> contacts_;
  AnnotatedColors colors_;
  std::map<std::string, std::string> textures_;  ///< file -> name of its material
  std::set<std::string_view> existing_;          ///< names of the model's declared meshes
  std::set<const urdf::Joint*> reported_;
  std::vector<std::pair<std::size_t, const urdf::Joint*>> followers_;
};

}  // namespace

extern constinit const SceneFormat scene_mjcf{
    .name = "mjcf",
    .help = "a MuJoCo world, for version 2.2 and later; with --form reference, which attaches the "
            "URDFs, for 3.2 and later",
    .write =
        [](const SceneExport& scene) {
          return scene.form == SceneForm::expand ? MjcfWriter(scene).run() : write_attached(scene);
        },
    .has_reference_form = true,
    .has_ground = true,
    .repeats_models = true,
    .has_motors = true,
    .has_armatures = true,
    .has_contacts = true,
    .has_link_pairs = true,
    .has_bitmasks = true,
    .has_neighbours = true,
    .welds_links = true,
    .usual_contacts = SelfCollision::srdf,
    .has_collisions = true,
    .fixes_world_roots = true,
    .repeated_parts = mjcf_repeated_parts};

}  // namespace smurf::scene_mjcf_file
