// SPDX-License-Identifier: BSD-3-Clause
#include "write/losses/found_things.hpp"

#include <algorithm>
#include <set>

#include "ast/urdf_schema.hpp"
#include "base/ranges.hpp"
#include "base/text/quoted.hpp"
#include "convert/import.hpp"
#include "convert/passes.hpp"
#include "link/imported_world.hpp"
#include "write/mjcf/mujoco_sensors.hpp"
#include "write/pages/viewer_sensors.hpp"
#include "write/parts/gazebo_elements.hpp"
#include "write/parts/loops.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf::things {
namespace {

/// Longer names are truncated, because a long name may be repeated for many parts. Messages show
/// fewer bytes than this.
constexpr std::size_t kMostOfName = 240;

/// Joints for which `part_of` returns a part.
template <class PartOf>
Found joints_with(const LinkedModel& model, PartOf part_of) {
  Found found;
  if (!model.robot) return found;
  for (const urdf::Joint& joint : model.robot->joints) {
    if (const std::optional<Span> span = part_of(joint)) {
      found.push_back({*span, joint.name.value_or({})});
    }
  }
  return found;
}

/// What URDF does not define.
struct Undefined {
  Found elements;  ///< without those that passes::extension_elements() finds
  Found attributes;
};

/// Adds what is undefined in an element of URDF, at any depth.
void add_undefined(xml::View element, const urdf::ElementSpec& spec, int depth, Undefined& found) {
  for (const xml::Attribute& at : element.attributes()) {
    if (at.name().starts_with("xmlns") || spec.attribute(at.name()) != nullptr) continue;
    found.attributes.push_back({at.name_span(), shortened(at.name(), kMostOfName)});
  }
  for (const xml::View child : element) {
    const urdf::ElementSpec* known =
        spec.child(child.name()) != nullptr ? urdf::find_element_spec(child.name()) : nullptr;
    if (known != nullptr) {
      add_undefined(child, *known, depth + 1, found);
    } else if (depth > 1) {
      found.elements.push_back({child.name_span(), shortened(child.name(), kMostOfName)});
    }
  }
}

Undefined find_undefined(const LinkedModel& model) {
  Undefined found;
  add_undefined(model.robot->document.view(), *urdf::find_element_spec("robot"), 0, found);
  return found;
}

/// The place of a setting that the scene lacks: the scene.
Found missing(const SceneExport& scene) {
  for (const SceneFile& file : scene.scene.scenes) {
    if (file.scene.physics) return {{file.scene.physics->span, scene.scene.path}};
  }
  if (scene.flat.instances.empty()) return {};
  return {{place_of(*scene.flat.instances.front().entity), scene.scene.path}};
}

/// Everybody expects gravity and a step of the simulator around a robot that is not in a scene.
bool is_lone_urdf(const SceneExport& scene) {
  return scene.scene.models.size() == 1 && !scene.scene.models.front().has_main &&
         !scene.scene.scenes.front().document;
}

}  // namespace

Found masses(const LinkedModel& model, SceneColumn) {
  Found found;
  if (!model.robot) return found;
  for (const urdf::Link& link : model.robot->links) {
    if (link.inertial) found.push_back({link.inertial->span, link.name.value_or({})});
  }
  return found;
}

Found collision_shapes(const LinkedModel& model, SceneColumn) {
  Found found;
  if (!model.robot) return found;
  for (const urdf::Link& link : model.robot->links) {
    for (const urdf::Collision& shape : link.collisions) {
      found.push_back({shape.span, link.name.value_or({})});
    }
  }
  return found;
}

Found movable_joints(const LinkedModel& model, SceneColumn) {
  return joints_with(model, [](const urdf::Joint& joint) -> std::optional<Span> {
    if (!joint.is_movable()) return std::nullopt;
    return joint.span;
  });
}

Found textures(const LinkedModel& model, SceneColumn column) {
  Found found;
  if (column == SceneColumn::html) return found;
  for (const MeshReference& reference : model.meshes) {
    if (column == SceneColumn::mjcf && is_texture_of_mujoco(reference)) continue;
    if (reference.is_texture) found.push_back({reference.span, reference.filename});
  }
  return found;
}

Found closing_joints(const LinkedModel& model, SceneColumn column) {
  Found found;
  if (!model.robot) return found;
  std::set<const urdf::Joint*> kept;
  if (column == SceneColumn::mjcf || column == SceneColumn::sdf || column == SceneColumn::sdf16) {
    for (const Loop& loop : loops_of(model)) kept.insert(loop.joint);
  }
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const urdf::Joint& joint = model.robot->joints[i];
    if (!closes_loop(model, i) || kept.contains(&joint)) continue;
    found.push_back({joint.span, joint.name.value_or({})});
  }
  return found;
}

Found unreached_parts(const LinkedModel& model, SceneColumn) {
  Found found;
  if (!model.robot) return found;
  const KinematicTree& tree = model.tree;
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const auto& parent = tree.joint_parent[i];
    const auto& child = tree.joint_child[i];
    if (parent && child && *parent != *child) continue;
    const urdf::Joint& joint = model.robot->joints[i];
    found.push_back({joint.span, joint.name.value_or({})});
  }
  const std::vector<std::optional<Pose>> poses = forward_kinematics(model, {});
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const urdf::Link& link = model.robot->links[i];
    if (!poses[i]) found.push_back({link.span, link.name.value_or({})});
  }
  return found;
}

Found velocities(const LinkedModel& model, SceneColumn) {
  return joints_with(model, [](const urdf::Joint& joint) -> std::optional<Span> {
    if (!joint.limit || !joint.limit->velocity) return std::nullopt;
    return joint.limit->velocity.span;
  });
}

Found own_collisions(const SceneExport& scene, SceneColumn) {
  Found found;
  const SelfCollision choice = scene.contacts.choice;
  if (choice != SelfCollision::as_usual && choice != SelfCollision::none) return found;
  for (const LinkedModel& model : scene.scene.models) {
    if (!model.robot) continue;
    const auto collides = [](const urdf::Link& link) { return !link.collisions.empty(); };
    const auto& links = model.robot->links;
    if (std::count_if(links.begin(), links.end(), collides) < 2) continue;
    found.push_back({{model.robot->document.source, 0, 0}, shortened(model.path, kMostOfName)});
  }
  return found;
}

Found disabled_pairs(const SceneExport& scene, SceneColumn column) {
  Found found;
  const bool is_sdf = column == SceneColumn::sdf || column == SceneColumn::sdf16;
  for (const LinkedModel& model : scene.scene.models) {
    const auto pairs = scene.contacts.left_out.find(&model);
    if (pairs == scene.contacts.left_out.end()) continue;
    const bool is_usual = scene.contacts.choice == SelfCollision::as_usual;
    if (is_sdf && is_usual && !touches_itself(model)) continue;
    for (const auto& [link, other] : pairs->second) {
      const urdf::Link& first = model.robot->links[link];
      found.push_back(
          {first.span, shortened(first.name.value_or({}), kMostOfName) + " and " +
                           shortened(model.robot->links[other].name.value_or({}), kMostOfName)});
    }
  }
  return found;
}

Found joint_frictions(const LinkedModel& model, SceneColumn) {
  return joints_with(model, [](const urdf::Joint& joint) -> std::optional<Span> {
    if (!joint.dynamics || joint.dynamics->friction.value_or(0) == 0) return std::nullopt;
    return joint.dynamics->friction.span;
  });
}

Found safety_controllers(const LinkedModel& model, SceneColumn) {
  return joints_with(model, [](const urdf::Joint& joint) -> std::optional<Span> {
    if (!joint.safety_controller) return std::nullopt;
    return joint.safety_controller->span;
  });
}

Found calibrations(const LinkedModel& model, SceneColumn) {
  return joints_with(model, [](const urdf::Joint& joint) -> std::optional<Span> {
    if (!joint.calibration) return std::nullopt;
    return joint.calibration->span;
  });
}

Found newer_limits(const LinkedModel& model, SceneColumn) {
  Found found;
  if (!model.robot) return found;
  for (const xml::Attribute* limit : passes::newer_limits(model, "1.0")) {
    found.push_back({limit->name_span(), std::string(limit->name())});
  }
  return found;
}

namespace {

/// The elements in <gazebo> that a format loses: all except the sensors that it has, plus the
/// settings of those sensors that it does not have.
Found other_than_sensors(const LinkedModel& model, SceneColumn column, const auto& sensors,
                         std::vector<xml::View> (*lost_settings)(xml::View sensor)) {
  Found found;
  std::set<xml::ElementId> written;
  for (const auto& sensor : sensors) written.insert(sensor.element);
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) {
      const bool is_of_mjcf = is_loop_of_gazebo(model, child) || is_of_spring(model, child);
      if (column == SceneColumn::mjcf && is_of_mjcf) continue;
      if (!written.contains(child.id())) {
        found.push_back({child.name_span(), name_or_tag(child)});
        continue;
      }
      const std::string name = shortened(name_or_tag(child), kMostOfName);
      for (const xml::View setting : lost_settings(child)) {
        found.push_back({setting.name_span(), std::string(setting.name()) + " of " + name});
      }
    }
  }
  return found;
}

}  // namespace

Found gazebo_elements(const LinkedModel& model, SceneColumn column, const MotorOptions& options) {
  Found found;
  if (!model.robot) return found;
  if (column == SceneColumn::mjcf) {
    return other_than_sensors(model, column, mujoco_sensors(model, options), unsaid_by_mujoco);
  }
  if (column == SceneColumn::html) {
    return other_than_sensors(model, column, viewer_sensors(model), unshown_settings);
  }
  const bool is_sdf = column == SceneColumn::sdf || column == SceneColumn::sdf16;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) {
      if (!is_sdf || !is_taken_by_gazebo(model, child)) {
        found.push_back({child.name_span(), name_or_tag(child)});
        continue;
      }
      for (const xml::View plugin : broken_plugins(child)) {
        found.push_back({plugin.name_span(), name_or_tag(plugin)});
      }
    }
  }
  return found;
}

Found other_extensions(const LinkedModel& model, SceneColumn) {
  Found found;
  if (!model.robot) return found;
  for (const xml::View element : passes::extension_elements(*model.robot)) {
    const bool has_row = element.name() == "gazebo" || element.name() == "transmission" ||
                         element.name() == "ros2_control";
    if (!has_row) found.push_back({element.name_span(), std::string(element.name())});
  }
  append(found, find_undefined(model).elements);
  return found;
}

Found other_attributes(const LinkedModel& model, SceneColumn) {
  return model.robot ? find_undefined(model).attributes : Found();
}

Found sensors(const LinkedModel& model, SceneColumn column, const MotorOptions& options) {
  std::set<const Sensor*> written;
  if (column == SceneColumn::mjcf) {
    for (const MujocoSensor& sensor : mujoco_sensors(model, options))
      written.insert(sensor.annotation);
  } else if (column == SceneColumn::html) {
    written = sensors_on_page(model);
  } else if (column == SceneColumn::sdf) {
    for (const Sensor& sensor : model.annotations.sensors) {
      const bool is_known = !passes::gazebo_type(sensor).empty() && sensor.name &&
                            !passes::gazebo_carrier(model, sensor).empty();
      if (is_known) written.insert(&sensor);
    }
  }
  Found found;
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!written.contains(&sensor)) found.push_back({sensor.span, sensor.name.value_or({})});
  }
  return found;
}

Found sensor_keys(const LinkedModel& model, SceneColumn column, const MotorOptions& options) {
  Found found;
  const auto add = [&](const Sensor& sensor, auto is_said) {
    for (FoundThing& key : other_keys(model, sensor, {})) {
      if (!is_said(sensor, key.name)) found.push_back(std::move(key));
    }
  };
  if (column == SceneColumn::mjcf) {
    const Sensor* last = nullptr;  // each ray of a scan becomes a sensor
    for (const MujocoSensor& sensor : mujoco_sensors(model, options)) {
      if (sensor.annotation == nullptr || sensor.annotation == last) continue;
      last = sensor.annotation;
      add(*last, is_said_by_mujoco);
    }
    return found;
  }
  if (column == SceneColumn::html) {
    for (const Sensor* sensor : sensors_on_page(model)) add(*sensor, is_shown);
    return found;
  }
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!passes::gazebo_type(sensor).empty()) add(sensor, passes::gazebo_says);
  }
  return found;
}

Found other_sections(const LinkedModel& model, SceneColumn) {
  Found found;
  for (const auto* sections : {&model.annotations.custom, &model.main.extra}) {
    for (const CustomSection& section : *sections) {
      // Their text names the URDF file.
      if (section.name.value == "urdf_extensions") continue;
      found.push_back({section.name.span, section.name.value});
    }
  }
  return found;
}

Found no_gravity(const SceneExport& scene, SceneColumn) {
  return scene.flat.physics.gravity || is_lone_urdf(scene) ? Found() : missing(scene);
}

/// Without one, a world of SDF has the step that is written then.
Found no_step(const SceneExport& scene, SceneColumn) {
  if (has_name_of_world(scene.scene.path)) return {};
  return scene.flat.physics.step_size || is_lone_urdf(scene) ? Found() : missing(scene);
}

Found ambient_lights(const SceneExport& scene, SceneColumn) {
  Found found;
  for (const Light* light : world_lights(scene)) {
    if (light->ambient) found.push_back({light->ambient.span, light->name.value_or({})});
  }
  return found;
}

Found light_details(const SceneExport& scene, SceneColumn) {
  Found found;
  for (const Light* light : world_lights(scene)) {
    const std::string name = light->name.value_or({});
    for (const auto* number : {&light->constant_attenuation, &light->linear_attenuation,
                               &light->quadratic_attenuation}) {
      if (number->written) found.push_back({number->span, name});
    }
    if (light->specular) found.push_back({light->specular.span, name});
  }
  return found;
}

Found start_positions(const SceneExport& scene, SceneColumn) {
  Found found;
  const auto is_bent = [](const auto& joint) { return joint.second != 0; };
  for (std::size_t i = 0; i < scene.flat.instances.size(); ++i) {
    const auto& positions = scene.flat.instances[i].joint_positions;
    if (std::none_of(positions.begin(), positions.end(), is_bent)) continue;
    const Entity& entity = *scene.flat.instances[i].entity;
    found.push_back(
        {entity.pose.written ? entity.pose.span : place_of(entity), scene.flat.instances[i].path});
  }
  return found;
}

Found free_robots(const SceneExport& scene, SceneColumn) {
  Found found;
  // A robot alone at the origin is where it would be without the joint.
  const auto& all = scene.flat.instances;
  if (all.size() == 1 && all.front().X_WE && *all.front().X_WE == Pose{}) return found;
  for (std::size_t i = 0; i < scene.flat.instances.size(); ++i) {
    const FlatInstance& instance = scene.flat.instances[i];
    const bool is_free = instance.anchor.kind == Attachment::Kind::none && instance.X_WE;
    if (!is_free || robot_of(scene.scene, i) == nullptr) continue;
    found.push_back({place_of(*instance.entity), instance.path});
  }
  return found;
}

Found world_roots(const SceneExport& scene, SceneColumn) {
  Found found;
  for (std::size_t i = 0; i < scene.flat.instances.size(); ++i) {
    const FlatInstance& instance = scene.flat.instances[i];
    const LinkedModel* model = robot_of(scene.scene, i);
    if (model == nullptr || instance.anchor.kind != Attachment::Kind::world) continue;
    const Entity& entity = *scene.flat.instances[i].entity;
    const SceneUse& use = scene.scene.use(scene.scene.instances[i]);
    const bool is_chosen = !entity.anchor.written && root_link_name(*model) == "world" &&
                           use.placement.anchor.kind == Attachment::Kind::none;
    if (is_chosen) found.push_back({place_of(entity), instance.path});
  }
  return found;
}

Found entity_keys(const SceneExport& scene, SceneColumn column) {
  const bool has_masks = column == SceneColumn::sdf || column == SceneColumn::mjcf;
  const auto is_said = [&](std::string_view key) {
    constexpr std::string_view kSaid[] = {"geometry", "physicmode", "extend",   "mass",   "movable",
                                          "material", "length",     "width",    "height", "t_width",
                                          "t_height", "t_scale",    "t_srcname"};
    if (ranges::contains(kSaid, key)) return true;
    if (key == "cfriction1") return has_masks || column == SceneColumn::usda;
    if (key == "cfriction2") return column == SceneColumn::sdf;
    return has_masks && (key == "coll_bitmask" || key == "bitmask");
  };
  Found found;
  for (std::size_t i = 0; i < scene.flat.instances.size(); ++i) {
    const FlatInstance& instance = scene.flat.instances[i];
    if (instance.shapes.empty()) continue;
    const std::string path = shortened(instance.path, kMostOfName);
    for (const ValueMember& member : instance.properties) {
      if (is_said(member.key)) continue;
      const Entity& entity = *scene.flat.instances[i].entity;
      found.push_back({place_of(entity), member.key + " of " + path});
    }
  }
  return found;
}

}  // namespace smurf::things
