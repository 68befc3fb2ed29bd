// SPDX-License-Identifier: BSD-3-Clause
// Phobos 2 reads angles as radians and quaternions as x, y, z, w (representation.py:141-160,
// utils/transform.py:9-48); it composes scenes as documented, from one of the three lists
// (multiple.py:20-30, 83-88, 126, 188).
#include <algorithm>
#include <unordered_map>

#include "base/files/path.hpp"
#include "flatten/dialect_parts.hpp"
#include "smurf/archive_files.hpp"

namespace smurf::readings::phobos_file {
namespace {

/// The rotation that scipy computes from the numbers; none if it raises an exception.
std::optional<Quaternion> quaternion_of(const Rotation& rotation, bool is_list) {
  const auto& [a, b, c, d] = rotation.values;
  switch (rotation.form) {
  case RotationForm::yaw:
    if (is_list) return std::nullopt;
    return from_rpy({0, 0, a});
  case RotationForm::euler: return from_rpy({a, b, c});
  case RotationForm::quaternion:
    if (rotation.is_mapping) return normalized({a, b, c, d});
    return normalized({d, a, b, c});
  case RotationForm::absent:
  case RotationForm::invalid: break;
  }
  return Quaternion{};
}

/// Whether the rotation is written as a list.
bool is_list(const LinkedScene& scene, const SceneUse& use, const Entity& entity) {
  if (entity.rotation.form == RotationForm::absent) return false;
  return yaml::View(*scene.file(use).document, entity.node).find("rotation").is_sequence();
}

Pose pose_of(const LinkedScene& scene, const SceneUse& use, const Entity& entity) {
  const auto turned = quaternion_of(entity.rotation, is_list(scene, use, entity));
  return {entity.position.value_or({0, 0, 0}), turned.value_or(Quaternion{})};
}

class EntityReader {
 public:
  explicit EntityReader(const LinkedScene& scene) : scene_(scene) {}

  SceneReading run() {
    // Outer uses come first.
    for (const SceneUse& use : scene_.uses) uses_.push_back(read(use));
    for (const Instance& instance : scene_.instances) placed_.push_back(read(instance));
    result_.entities.resize(placed_.size());
    for (std::size_t i = 0; i < placed_.size(); ++i) compose(i);
    return std::move(result_);
  }

 private:
  /// The pose relative to the frame of the documented parent, or the reason why there is none.
  struct Placed {
    Pose X_PE;
    std::string refusal;
    std::string note;
    bool is_composed = false;
  };

  /// The list that Phobos reads; it is the same for all uses of a file.
  EntityList list_of(const SceneUse& use) {
    const std::vector<Entity>& entities = scene_.file(use).scene.entities;
    const auto [known, is_new] = lists_.try_emplace(&entities, EntityList::smurfs);
    if (!is_new) return known->second;
    for (const EntityList list : {EntityList::entities, EntityList::smurfa}) {
      const auto is_in = [&](const Entity& entity) { return entity.list == list; };
      if (std::any_of(entities.begin(), entities.end(), is_in)) return known->second = list;
    }
    return EntityList::smurfs;
  }

  Placed place(const Entity& entity, const SceneUse& around, const Placed* frame) {
    Placed placed;
    if (scene_.file(around).drawing) {
      placed.refusal = "reads no drawings";
      return placed;
    }
    if (frame != nullptr && !frame->refusal.empty()) return *frame;
    if (is_archive_type(entity_type(entity))) {
      placed.refusal = "reads no archives";
      return placed;
    }
    if (entity.list != list_of(around)) {
      placed.refusal = "reads one of the lists `entities`, `smurfa`, `smurfs` only";
      return placed;
    }
    const auto turned = quaternion_of(entity.rotation, is_list(scene_, around, entity));
    if (!turned) {
      placed.refusal = "stops at a `rotation` that is a list of one number";
      return placed;
    }
    const Pose own{entity.position.value_or({0, 0, 0}), *turned};
    if (angle_between(*turned, to_quaternion(entity.rotation)) > 1e-9) {
      add_note(placed.note, entity.rotation.form == RotationForm::quaternion
                                ? "reads the quaternion as x, y, z, w"
                                : "reads the angles as radians");
    }
    const bool inherits = frame != nullptr && has_no_parent_link(entity);
    placed.X_PE = inherits ? frame->X_PE * own : own;
    if (inherits && placed.note.empty()) placed.note = frame->note;
    return placed;
  }

  Placed read(const SceneUse& use) {
    if (!use.outer) return {};
    const SceneUse& around = scene_.uses[to_size(*use.outer)];
    const Placed* frame = around.outer ? &uses_[to_size(*use.outer)] : nullptr;
    return place(*scene_.entity(use), around, frame);
  }

  Placed read(const Instance& instance) {
    const SceneUse& around = scene_.use(instance);
    const Placed* frame = around.outer ? &uses_[to_size(instance.use)] : nullptr;
    const Entity& entity = scene_.entity(instance);
    Placed placed = place(entity, around, frame);
    const std::string extension = path::to_lower(path::extension(entity.file.value_or({})));
    if (placed.refusal.empty() && extension != ".smurf" && extension != ".urdf") {
      placed.refusal = "reads models and scenes only, and recognises them by the name of their "
                       "`file`";
    }
    return placed;
  }

  /// Parents first; there are no cycles, because the documented reading has succeeded.
  void compose(std::size_t index) {
    std::vector<std::size_t> chain;
    for (std::size_t at = index; !placed_[at].is_composed;) {
      chain.push_back(at);
      placed_[at].is_composed = true;
      const Attachment& parent = scene_.instances[at].placement.parent;
      if (parent.kind != Attachment::Kind::link) break;
      at = to_size(parent.instance);
    }
    for (; !chain.empty(); chain.pop_back()) compose_one(chain.back());
  }

  void compose_one(std::size_t index) {
    const Instance& instance = scene_.instances[index];
    Placed& placed = placed_[index];
    EntityReading& reading = result_.entities[index];
    reading.note = placed.refusal.empty() ? placed.note : placed.refusal;
    if (!placed.refusal.empty() || !instance.X_WE) return;
    reading.parent = instance.placement.parent;
    reading.anchor = instance.placement.anchor;
    // Phobos has no code for `pose`: all joints stay at zero (multiple.py:16-43).
    if (instance.joint_pose != JointPoseIndex{}) add_note(reading.note, "does not apply `pose`");
    if (reading.parent.kind != Attachment::Kind::link) {
      reading.X_WE = placed.X_PE;
      return;
    }
    const EntityReading& parent = result_.entities[to_size(reading.parent.instance)];
    const auto X_RL =
        link_frame(scene_, result_, reading.parent.instance, reading.parent.link, frames_);
    if (parent.X_WE && X_RL) {
      reading.X_WE = *parent.X_WE * *X_RL * placed.X_PE;
      if (reading.note.empty()) reading.note = parent.note;
    } else {
      reading.note = "does not load what it is placed on";
    }
  }

  const LinkedScene& scene_;
  std::unordered_map<const std::vector<Entity>*, EntityList> lists_;
  std::vector<Placed> uses_, placed_;
  SceneReading result_;
  LinkFrames frames_;
};

SceneReading read(const LinkedScene& scene) { return EntityReader(scene).run(); }

}  // namespace

extern constinit const Dialect phobos{.name = "phobos",
                                      .help = "as Phobos 2 reads it",
                                      .read = read,
                                      .pose_of = pose_of,
                                      .is_moved_by_include = has_no_parent_link};

}  // namespace smurf::readings::phobos_file
