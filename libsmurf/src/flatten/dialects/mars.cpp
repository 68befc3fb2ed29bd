// SPDX-License-Identifier: BSD-3-Clause
// MARS, with all its quirks: an include overwrites the keys of its entities
// (SMURFLoader.cpp:350-380, 667-755), entities are created in another order (580-637), names are
// global, and an unknown name means the world (SimEntity.cpp:344-501).
#include <map>
#include <queue>

#include "ast/scene_reader.hpp"
#include "base/files/path.hpp"
#include "base/numbers/quantity.hpp"
#include "base/text/quoted.hpp"
#include "flatten/dialect_parts.hpp"
#include "smurf/archive_files.hpp"

namespace smurf::readings::mars_file {
namespace {

/// The keys of an entity after the enclosing includes have overwritten them.
struct Keys {
  std::string parent, anchor;
  bool has_parent = false;
  Vector3 position{};
  Quaternion rotation;  ///< of any length, because MARS does not normalise it
  std::string refusal;  ///< the reason why the entity is not loaded

  bool is_relative() const { return has_parent && parent != "world"; }
};

/// Rotates by a quaternion as Eigen does, which stretches if the length is not one.
Vector3 rotate_raw(const Quaternion& q, const Vector3& v) {
  const auto cross = [](const Vector3& a, const Vector3& b) {
    return Vector3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Vector3 axis{q.x, q.y, q.z};
  Vector3 uv = cross(axis, v);
  for (double& component : uv) component *= 2;
  const Vector3 second = cross(axis, uv);
  return {v[0] + q.w * uv[0] + second[0], v[1] + q.w * uv[1] + second[1],
          v[2] + q.w * uv[2] + second[2]};
}

Quaternion as_written(const Rotation& rotation) {
  if (rotation.form != RotationForm::quaternion) return to_quaternion(rotation);
  return {rotation.values[0], rotation.values[1], rotation.values[2], rotation.values[3]};
}

Keys keys_of(const Entity& entity) {
  return {.parent = entity.parent.value_or({}),
          .anchor = entity.anchor.value_or({}),
          .has_parent = entity.parent.written,
          .position = entity.position.value_or({0, 0, 0}),
          .rotation = as_written(entity.rotation),
          .refusal = {}};
}

/// Overwrites an entity of an included scene with the keys of the include.
void include(Keys& keys, const Entity& entity, const Keys& around) {
  if (!around.refusal.empty()) keys.refusal = around.refusal;
  if (keys.is_relative() || !keys.refusal.empty()) return;
  if (entity.position_is_mapping || entity.rotation.is_mapping) {
    keys.refusal = "stops at a pose that is a mapping, inside an included scene";
    return;
  }
  if (entity.list != EntityList::smurfa || entity.root.value_or(false)) {
    keys.anchor = around.anchor.empty() ? "none" : around.anchor;
    keys.parent = around.has_parent ? around.parent : "world";
    keys.has_parent = true;
  }
  const Vector3 moved = rotate_raw(around.rotation, keys.position);
  for (std::size_t i = 0; i < 3; ++i) keys.position[i] = around.position[i] + moved[i];
  keys.rotation = normalized(multiply(around.rotation, keys.rotation));
}

/// "A" of "A::link"; empty for other texts.
std::string entity_part(const std::string& reference) {
  const std::size_t separator = reference.find("::");
  return separator == std::string::npos ? std::string() : reference.substr(0, separator);
}

/// The order of creation. In every round, MARS creates, in file order, entities without references
/// and entities whose references exist. The remaining entities are created in file order. The
/// rounds are computed, not simulated: an entity is created in the round of its last reference, or
/// in the next round if it comes before that reference in the file.
class CreationOrder {
 public:
  CreationOrder(const LinkedScene& scene, const std::vector<Keys>& keys)
      : scene_(scene), waiting_(keys.size(), 0), is_created_(keys.size(), false) {
    for (std::size_t i = 0; i < keys.size(); ++i) add(i, keys[i]);
  }

  std::vector<std::size_t> run() {
    while (!ready_.empty()) {
      const auto [round, index] = ready_.top();
      ready_.pop();
      create(round, index);
    }
    for (std::size_t i = 0; i < is_created_.size(); ++i) {
      if (!is_created_[i]) order_.push_back(i);
    }
    return std::move(order_);
  }

 private:
  void add(std::size_t index, const Keys& keys) {
    // Scenes of old MARS are loaded while the file is read, before other entities.
    const bool is_old = is_old_scene(scene_.instances[index].type);
    const std::string first = is_old ? std::string() : entity_part(keys.parent);
    std::string second = keys.anchor == "parent" ? first : entity_part(keys.anchor);
    if (is_old) second.clear();
    if (first.empty() && second.empty()) {
      ready_.emplace(is_old ? 0 : 1, index);
      return;
    }
    // A missing reference counts as a reference to the entity without a name.
    wait(index, first);
    if (second != first) wait(index, second);
  }

  void wait(std::size_t index, const std::string& name) {
    ++waiting_[index];
    dependents_[name].push_back(index);
  }

  void create(std::size_t round, std::size_t index) {
    is_created_[index] = true;
    order_.push_back(index);
    const auto dependents = dependents_.find(scene_.instances[index].name);
    if (dependents == dependents_.end()) return;
    for (const std::size_t dependent : dependents->second) {
      if (--waiting_[dependent] == 0) {
        ready_.emplace(dependent > index ? round : round + 1, dependent);
      }
    }
    dependents_.erase(dependents);
  }

  using Turn = std::pair<std::size_t, std::size_t>;  ///< round, index
  const LinkedScene& scene_;
  std::vector<std::size_t> waiting_;
  std::vector<bool> is_created_;
  std::map<std::string, std::vector<std::size_t>> dependents_;
  std::priority_queue<Turn, std::vector<Turn>, std::greater<>> ready_;
  std::vector<std::size_t> order_;
};

class EntityReader {
 public:
  explicit EntityReader(const LinkedScene& scene) : scene_(scene) {
    result_.entities.resize(scene.instances.size());
  }

  SceneReading run() {
    std::vector<Keys> uses;
    for (const SceneUse& use : scene_.uses) uses.push_back(keys_of(use, uses));
    std::vector<Keys> keys;
    for (const Instance& instance : scene_.instances) {
      keys.push_back(keys_of(instance, uses[to_size(instance.use)]));
    }
    for (const std::size_t index : CreationOrder(scene_, keys).run()) create(index, keys[index]);
    return std::move(result_);
  }

 private:
  static constexpr const char* kNotFromDrawing =
      "does not load entities of this type from a drawing";

  static constexpr const char* kNotFromArchive = "loads nothing from an archive";

  bool is_drawn(UseIndex use) const {
    return scene_.file(scene_.uses[to_size(use)]).drawing.has_value();
  }

  Keys keys_of(const SceneUse& use, const std::vector<Keys>& outer) const {
    if (!use.outer) return {};
    const Entity& entity = *scene_.entity(use);
    Keys keys = mars_file::keys_of(entity);
    if (is_archive_type(entity_type(entity))) keys.refusal = kNotFromArchive;
    if (is_drawn(*use.outer)) keys.refusal = kNotFromDrawing;
    if (scene_.uses[to_size(*use.outer)].outer) include(keys, entity, outer[to_size(*use.outer)]);
    return keys;
  }

  Keys keys_of(const Instance& instance, const Keys& around) const {
    const Entity& entity = scene_.entity(instance);
    Keys keys = mars_file::keys_of(entity);
    const bool is_nested = scene_.use(instance).outer.has_value();
    if (is_archive_type(instance.type)) keys.refusal = kNotFromArchive;
    if (is_drawn(instance.use)) {
      if (kind_of(instance.type) == EntityKind::model || is_old_scene(instance.type)) {
        keys.refusal = kNotFromDrawing;
      } else if (instance.type == "primitive") {
        keys.position = {};
        keys.rotation = {};
      }
      return keys;
    }
    if (instance.type == "primitive") {
      if (is_nested) keys.refusal = "stops at a primitive inside an included scene";
      const bool is_list =
          (entity.position && !entity.position_is_mapping) ||
          (entity.rotation.form != RotationForm::absent && !entity.rotation.is_mapping);
      if (!is_nested && is_list) keys.refusal = "stops at the pose of a primitive that is a list";
      keys.parent.clear();
      keys.anchor.clear();
      return keys;
    }
    if (is_nested) include(keys, entity, around);
    if (is_old_scene(instance.type) && instance.name.empty()) {
      // Only an old node with a name becomes an entity, which can be moved.
      keys.position = {};
      keys.rotation = {};
    }
    for (const std::string_view type : kPhobosTypes) {
      if (instance.type == type) keys.refusal = "has no entities of type " + quoted(type);
    }
    const std::string lower = path::to_lower(instance.type);
    const bool is_misspelt = !instance.model && type_meant(scene_, instance.type);
    if (is_misspelt || (instance.model && instance.type != lower)) {
      keys.refusal = "has no entities of type " + quoted(instance.type);
    }
    return keys;
  }

  void create(std::size_t index, Keys keys) {
    const Instance& instance = scene_.instances[index];
    EntityReading& reading = result_.entities[index];
    reading.note = keys.refusal;
    if (!keys.refusal.empty() || !instance.X_WE) return;
    const Entity& entity = scene_.entity(instance);
    std::string pose = entity.pose.value_or({});
    const LinkedModel* model = scene_.model(instance);
    if (model != nullptr) override_keys(*model, keys, pose, reading.note);
    place(index, keys);
    if (model != nullptr && model->robot) add_joints(entity, *model, pose, reading);
    // Entities are found by their written names; of equal names, the first one created is found.
    first_of_name_.emplace(instance.name, InstanceIndex{static_cast<std::uint32_t>(index)});
  }

  /// The main file of a model overrides the keys of the entity.
  static void override_keys(const LinkedModel& model, Keys& keys, std::string& pose,
                            std::string& note) {
    if (!model.has_main || model.main.extra.empty() || !model.files.front().document) return;
    const yaml::View main = model.files.front().document->view();
    DiagnosticSink reported_elsewhere;
    const Entity own = read_entity(main, EntityList::entities, reported_elsewhere);
    const Keys own_keys = mars_file::keys_of(own);
    if (own.position) keys.position = own_keys.position;
    if (own.rotation.form != RotationForm::absent) keys.rotation = own_keys.rotation;
    if (own.anchor) keys.anchor = own_keys.anchor;
    if (own.pose) pose = *own.pose;
    if (own.parent) {
      keys.parent = own_keys.parent;
      keys.has_parent = true;
    }
    if (own.position || own.rotation.form != RotationForm::absent || own.anchor || own.parent ||
        own.pose) {
      add_note(note, "uses the keys of the model's main file instead of the scene's");
    }
  }

  struct Frame {
    Attachment attachment;
    Pose X_WF;
  };

  /// The entity, if it is already created.
  std::optional<Frame> find_frame(const std::string& reference) {
    const std::size_t separator = reference.find("::");
    if (separator == std::string::npos) return std::nullopt;
    const auto found = first_of_name_.find(reference.substr(0, separator));
    if (found == first_of_name_.end()) return std::nullopt;
    const std::string link = reference.substr(separator + 2);
    const EntityReading& target = result_.entities[to_size(found->second)];
    const auto X_EF = link_frame(scene_, result_, found->second, link, frames_);
    if (!X_EF || !target.X_WE) return std::nullopt;
    return Frame{{Attachment::Kind::link, found->second, link}, *target.X_WE * *X_EF};
  }

  void place(std::size_t index, const Keys& keys) {
    const Placement& meant = scene_.instances[index].placement;
    EntityReading& reading = result_.entities[index];
    Pose X_WP;
    const bool has_frame =
        keys.has_parent && !keys.parent.empty() && keys.parent != "none" && keys.parent != "world";
    if (has_frame) {
      if (const auto frame = find_frame(keys.parent)) {
        reading.parent = frame->attachment;
        X_WP = frame->X_WF;
      } else {
        add_note(reading.note, "does not find the parent " + quoted(keys.parent) +
                                   " when it creates the entity, and uses the world");
      }
    }
    reading.X_WE = X_WP * Pose{keys.position, normalized(keys.rotation)};
    if (!is_usable(*reading.X_WE)) {
      // MARS does not normalise quaternions, so those of nested scenes are multiplied.
      reading.X_WE.reset();
      reading.note = "computes a pose that is not finite";
      return;
    }
    reading.anchor = anchor_of(keys.anchor, reading.parent);
    if (reading.anchor == meant.anchor) return;
    if (reading.anchor.kind == Attachment::Kind::none) add_note(reading.note, "loses the anchor");
    if (reading.anchor.kind == Attachment::Kind::world)
      add_note(reading.note, "fixes it to the world");
  }

  Attachment anchor_of(const std::string& anchor, const Attachment& parent) {
    constexpr Attachment::Kind kWorld = Attachment::Kind::world;
    if (anchor.empty() || anchor == "none") return {};
    if (anchor == "parent") {
      return parent.kind == Attachment::Kind::link ? parent : Attachment{kWorld, {}, {}};
    }
    const auto frame = find_frame(anchor);
    return frame ? frame->attachment : Attachment{kWorld, {}, {}};
  }

  /// Sliders go the other way (SimJoint.cpp:524-528).
  void add_joints(const Entity& entity, const LinkedModel& model, const std::string& pose,
                  EntityReading& reading) {
    reading.joint_pose = poses_.of(entity, model, pose, [&] {
      JointPositions positions = positions_of_pose(entity, model, pose, joint_of_motor(model));
      std::string& note = notes_.emplace_back();
      for (auto& [name, position] : positions) {
        const auto joint = model.joint_names.find(name);
        if (!joint || model.robot->joints[*joint].type != urdf::JointType::prismatic) continue;
        position = -position;
        if (position != 0)
          add_note(note, "moves the slider " + quoted(name) + " in the opposite direction");
      }
      return positions;
    });
    const std::string& note = notes_[to_size(reading.joint_pose)];
    if (!note.empty()) add_note(reading.note, note);
  }

  const LinkedScene& scene_;
  SceneReading result_;
  JointPoseTable poses_{result_.joint_poses};
  std::vector<std::string> notes_{1};  ///< by joint pose
  std::map<std::string, InstanceIndex> first_of_name_;
  LinkFrames frames_;
};

SceneReading read(const LinkedScene& scene) { return EntityReader(scene).run(); }

}  // namespace

extern constinit const Dialect mars{
    .name = "mars",
    .help = "as MARS reads it, with all its quirks",
    .read = read,
    .pose_of = documented_pose,
    .is_moved_by_include = [](const Entity& entity) { return !keys_of(entity).is_relative(); }};

}  // namespace smurf::readings::mars_file
