// SPDX-License-Identifier: BSD-3-Clause
#include "write/pages/viewer_data.hpp"

#include <deque>
#include <set>

#include "base/files/path.hpp"
#include "link/kinematics.hpp"
#include "link/shape_solids.hpp"
#include "lint/geometry_queries.hpp"
#include "write/losses/scene_losses.hpp"
#include "write/pages/viewer_images.hpp"
#include "write/pages/viewer_meshes.hpp"
#include "write/pages/viewer_sensors.hpp"
#include "write/parts/annotated_looks.hpp"
#include "write/parts/body_inertia.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/text/json_printer.hpp"

namespace smurf {
namespace {

using Layout = JsonPrinter::Layout;

/// Writes the models and entities of one version of a scene. For the old version, `newer` is the
/// new one; its models and entities come first in the lists.
class VersionData {
 public:
  VersionData(const SceneExport& scene, const SceneExport* newer, ViewerMeshes& meshes,
              ViewerImages& images, JsonPrinter& json)
      : scene_(scene),
        is_old_(newer != nullptr),
        models_before_(newer == nullptr ? 0 : newer->flat.models.size()),
        entities_before_(newer == nullptr ? 0 : newer->flat.instances.size()),
        losses_(scene, SceneColumn::html, "HTML"),
        meshes_(meshes),
        images_(images),
        json_(json) {}

  void add_models() {
    for (const FlatModel& model : scene_.flat.models) add_model(model);
  }
  void add_entities() {
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) add_entity(i);
    losses_.table();
  }

 private:
  /// A list with a line for each item.
  void begin_lines(std::string_view key) {
    json_.key(key);
    json_.begin_list(Layout::block);
  }

  void add_pose(std::string_view key, const Pose& pose) {
    const Vector3& p = pose.position;
    const Quaternion& q = pose.orientation;
    json_.member(key, {p[0], p[1], p[2], q.w, q.x, q.y, q.z});
  }

  void add_name(const Field<std::string>& name) {
    if (name) json_.member("name", *name);
  }

  void add_number(std::string_view key, const Field<double>& value) {
    if (!value) return;
    json_.key(key);
    json_.number(*value);
  }

  void add_index(std::string_view key, std::size_t index) {
    json_.key(key);
    json_.integer(static_cast<std::int64_t>(index));
  }

  void add_model(const FlatModel& flat) {
    const LinkedModel& model = scene_.scene.models[to_size(flat.source)];
    json_.begin_object(Layout::block);
    json_.member("name", flat.id);
    json_.member("file", flat.file);
    add_version();
    begin_lines("links");
    if (model.robot) add_links(flat, model);
    json_.end();
    begin_lines("joints");
    if (model.robot) {
      for (std::size_t i = 0; i < model.robot->joints.size(); ++i) add_joint(model, i);
    }
    json_.end();
    add_joint_poses(model);
    print_devices(model, json_);
    print_sensors(model, json_);
    json_.end();
  }

  void add_links(const FlatModel& flat, const LinkedModel& model) {
    const std::vector<std::optional<Pose>> X_RL = forward_kinematics(model, {});
    const AnnotatedLooks looks(model, flat);
    for (std::size_t i = 0; i < model.robot->links.size(); ++i) {
      const urdf::Link& link = model.robot->links[i];
      json_.begin_object();
      add_name(link.name);
      const std::optional<JointIndex> above = model.tree.parent_joint[i];
      if (above) add_index("joint", to_size(*above));
      if (!X_RL[i]) {
        json_.key("unplaced");
        json_.boolean(true);
      }
      if (const std::optional<LinkInertial> mass = inertial_of(link)) {
        json_.key("mass");
        json_.number(mass->mass);
        add_pose("com", mass->X_LC);
        json_.member("inertia", {mass->ixx, mass->ixy, mass->ixz, mass->iyy, mass->iyz, mass->izz});
        if (const auto solid = solid_of(model, link)) add_solid_inertia(*solid, mass->mass);
      }
      json_.key("visuals");
      json_.begin_list();
      for (const urdf::Visual& visual : link.visuals) {
        add_part(visual, looks.of(visual), flat, model);
      }
      json_.end();
      json_.key("collisions");
      json_.begin_list();
      for (const urdf::Collision& shape : link.collisions) {
        add_part(shape, {}, flat, model);
      }
      json_.end();
      json_.end();
    }
  }

  /// The inertia that the shapes have when they are filled with the mass.
  void add_solid_inertia(const Solid& solid, double mass) {
    const auto [xx, yy, zz, xy, xz, yz] = unit_inertia(solid);
    json_.key("solid");
    json_.begin_object();
    add_pose("com", {solid.center, {}});
    json_.member("inertia", {mass * xx, mass * xy, mass * xz, mass * yy, mass * yz, mass * zz});
    json_.end();
  }

  template <class Part>
  void add_part(const Part& part, const AnnotatedLooks::Look& look, const FlatModel& flat,
                const LinkedModel& model) {
    const std::optional<FlatGeometry> geometry = to_flat(part.geometry, flat);
    if (!geometry) return;
    json_.begin_object();
    add_name(part.name);
    const bool is_textured = look.texture && add_texture(*look.texture, part.span, *geometry);
    add_solid({urdf::to_pose(part.origin), *geometry, look.color, part.span},
              bounding_box(model, part.geometry), is_textured);
    const bool is_visual = std::is_same_v<Part, urdf::Visual>;
    if (is_visual && !look.color && !look.texture) name_own_textures(*geometry, part.span);
    json_.end();
  }

  /// Whether the shape has coordinates for the texture, even if the image cannot be shown.
  bool add_texture(const std::string& file, Span place, const FlatGeometry& geometry) {
    const auto* mesh = std::get_if<FlatMesh>(&geometry);
    std::string why = mesh == nullptr ? "" : meshes_.find_textured(mesh->file, place).why_none;
    const bool has_coordinates = why.empty();
    if (has_coordinates) {
      const ViewerImages::Known& known = images_.find(file);
      if (known.index) add_index("texture", *known.index);
      why = known.why_none;
    } else {
      why = "is on a mesh that " + why;
    }
    if (why.empty()) return true;
    lose_texture(file, place, why);
    return has_coordinates;
  }

  /// The page shows the colours of a mesh file, but not its images.
  void name_own_textures(const FlatGeometry& geometry, Span place) {
    const auto* mesh = std::get_if<FlatMesh>(&geometry);
    if (mesh == nullptr || !meshes_.find(mesh->file, place).has_textures) return;
    lose_texture(mesh->file, place, "has textures of its own, which are not shown");
  }

  /// Thousands of visuals may have one texture.
  void lose_texture(const std::string& file, Span place, const std::string& why) {
    if (lost_textures_.insert(file).second) losses_.note("textures", place, file);
    meshes_.add_unseen(file, why);
  }

  void add_joint(const LinkedModel& model, std::size_t index) {
    const urdf::Joint& joint = model.robot->joints[index];
    json_.begin_object();
    add_name(joint.name);
    json_.member("type", joint.type_name.value_or({}));
    if (const auto parent = model.tree.joint_parent[index]) add_index("parent", to_size(*parent));
    if (const auto child = model.tree.joint_child[index]) add_index("child", to_size(*child));
    add_pose("pose", urdf::to_pose(joint.origin));
    if (joint.has_one_axis()) {
      json_.key("axis");
      json_.vector(joint.axis.value_or(Vector3{1, 0, 0}));
    }
    if (joint.limit) {
      add_number("lower", joint.limit->lower);
      add_number("upper", joint.limit->upper);
      add_number("effort", joint.limit->effort);
      add_number("velocity", joint.limit->velocity);
    }
    if (joint.dynamics) {
      add_number("damping", joint.dynamics->damping);
      add_number("friction", joint.dynamics->friction);
    }
    add_mimic(model, joint);
    json_.end();
  }

  void add_mimic(const LinkedModel& model, const urdf::Joint& joint) {
    if (!joint.mimic || !joint.mimic->joint || !is_followable(model, joint)) return;
    const auto leader = model.joint_names.find(*joint.mimic->joint);
    if (!leader) return;
    add_index("leader", *leader);
    json_.key("multiplier");
    json_.number(joint.mimic->multiplier.value_or(1));
    json_.key("offset");
    json_.number(joint.mimic->offset.value_or(0));
  }

  void add_joint_poses(const LinkedModel& model) {
    begin_lines("poses");
    std::set<std::string> names;
    for (const JointPoseSet& set : model.annotations.poses) {
      if (!set.name || !names.insert(*set.name).second) continue;
      json_.begin_object();
      add_name(set.name);
      add_positions(to_joint_positions(model, set));
      json_.end();
    }
    json_.end();
  }

  void add_positions(const JointPositions& positions) {
    json_.key("positions");
    json_.begin_object();
    for (const auto& [joint, position] : positions) {
      json_.key(joint);
      json_.number(position);
    }
    json_.end();
  }

  void add_entity(std::size_t index) {
    const FlatInstance& entity = scene_.flat.instances[index];
    json_.begin_object();
    json_.member("path", entity.path);
    json_.member("type", entity.type);
    add_version();
    if (entity.model) add_index("model", models_before_ + *entity.model);
    if (entity.X_WE) add_pose("pose", *entity.X_WE);
    if (entity.anchor.kind == Attachment::Kind::world) {
      json_.key("anchored");
      json_.boolean(true);
    }
    add_support(index);
    add_positions(scene_.joint_positions(index));
    json_.key("shapes");
    json_.begin_list();
    const Span place = place_of(*scene_.flat.instances[index].entity);
    for (const FlatShape& shape : entity.shapes) {
      json_.begin_object();
      if (!shape.name.empty()) json_.member("name", shape.name);
      add_solid({shape.X_ES, shape.geometry, shape.color, place}, std::nullopt, false);
      if (!shape.color) name_own_textures(shape.geometry, place);
      json_.end();
    }
    json_.end();
    json_.end();
  }

  /// The link with which an entity moves: that of its anchor, otherwise that of its parent.
  void add_support(std::size_t index) {
    const FlatInstance& here = scene_.flat.instances[index];
    for (const FlatAttachment* attachment : {&here.anchor, &here.parent}) {
      if (attachment->kind != Attachment::Kind::link || !here.X_WE) continue;
      const FlatInstance& other = scene_.flat.instances[attachment->index];
      const LinkedModel* model = robot_of(scene_.scene, attachment->index);
      if (model == nullptr || !other.X_WE) continue;
      const std::optional<std::uint32_t> link = model->link_names.find(attachment->link);
      if (!link) continue;
      const std::optional<Pose>& X_OL = frames_of(scene_, attachment->index, frames_)[*link];
      if (!X_OL) continue;
      json_.key(attachment == &here.anchor ? "anchor" : "parent");
      json_.begin_object();
      add_index("entity", entities_before_ + attachment->index);
      add_index("link", *link);
      add_pose("pose", inverse(*other.X_WE * *X_OL) * *here.X_WE);
      json_.end();
      return;
    }
  }

  /// `around` is the box shown for an unreadable mesh.
  void add_solid(const LinkShape& shape, const std::optional<Box>& around, bool is_textured) {
    if (shape.X_LS != Pose{}) add_pose("pose", shape.X_LS);
    if (shape.color) {
      const Rgba& color = *shape.color;
      json_.member("color", {color[0], color[1], color[2], color[3]});
    }
    if (const auto* box = std::get_if<FlatBox>(&shape.geometry)) {
      json_.member("box", {box->size[0], box->size[1], box->size[2]});
    } else if (const auto* sphere = std::get_if<FlatSphere>(&shape.geometry)) {
      json_.member("sphere", {sphere->radius});
    } else if (const auto* cylinder = std::get_if<FlatCylinder>(&shape.geometry)) {
      json_.member("cylinder", {cylinder->radius, cylinder->length});
    } else if (const auto* capsule = std::get_if<FlatCapsule>(&shape.geometry)) {
      json_.member("capsule", {capsule->radius, capsule->length});
    } else if (const auto* plane = std::get_if<FlatPlane>(&shape.geometry)) {
      json_.member("plane", {plane->length, plane->width});
    } else if (const auto* mesh = std::get_if<FlatMesh>(&shape.geometry)) {
      add_mesh(*mesh, shape, around, is_textured);
    } else if (const auto* map = std::get_if<FlatHeightmap>(&shape.geometry)) {
      losses_.unseen_shape(shape.span, shape.geometry, {});
      meshes_.add_unseen(map->file, "is a heightmap");
      json_.member("around", {-map->length / 2, -map->width / 2, 0, map->length / 2, map->width / 2,
                              map->height});
    }
  }

  void add_mesh(const FlatMesh& mesh, const LinkShape& shape, const std::optional<Box>& around,
                bool is_textured) {
    const ViewerMeshes::Known& known = is_textured ? meshes_.find_textured(mesh.file, shape.span)
                                                   : meshes_.find(mesh.file, shape.span);
    if (known.index) {
      add_index("mesh", *known.index);
      if (mesh.scale != Vector3{1, 1, 1}) {
        json_.key("scale");
        json_.vector(mesh.scale);
      }
      return;
    }
    losses_.unseen_shape(shape.span, shape.geometry, known.why_none);
    const std::string_view package = losses_.lost_package(mesh.file);
    meshes_.add_unseen(mesh.file, package.empty() ? known.why_none : "was not found", package);
    if (!around) return;
    const Vector3& low = around->low;
    const Vector3& high = around->high;
    json_.member("around", {low[0], low[1], low[2], high[0], high[1], high[2]});
  }

  void add_version() {
    if (!is_old_) return;
    json_.key("old");
    json_.boolean(true);
  }

  const SceneExport& scene_;
  bool is_old_;
  std::size_t models_before_, entities_before_;
  SceneLosses losses_;
  LinkFrames frames_;
  std::set<std::string> lost_textures_;  ///< each is listed once, however many visuals have it
  ViewerMeshes& meshes_;
  ViewerImages& images_;
  JsonPrinter& json_;
};

}  // namespace

std::optional<std::string> viewer_data(const SceneExport& scene, const SceneExport* before) {
  JsonPrinter json(scene.most_bytes);
  ViewerMeshes meshes(scene, before != nullptr);
  ViewerImages images(scene);
  std::deque<VersionData> versions;
  versions.emplace_back(scene, nullptr, meshes, images, json);
  if (before != nullptr) versions.emplace_back(*before, &scene, meshes, images, json);
  json.begin_object(Layout::block);
  json.member("scene", path::file_name(scene.flat.scene));
  json.key("models");
  json.begin_list(Layout::block);
  for (VersionData& version : versions) version.add_models();
  json.end();
  json.key("entities");
  json.begin_list(Layout::block);
  for (VersionData& version : versions) version.add_entities();
  json.end();
  json.key("meshes");
  meshes.print(json);
  json.key("textures");
  images.print(json);
  json.key("unseen");
  meshes.print_unseen(json);
  json.end();
  return json.take();
}

}  // namespace smurf
