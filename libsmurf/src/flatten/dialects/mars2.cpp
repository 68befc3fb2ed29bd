// SPDX-License-Identifier: BSD-3-Clause
// MARS 2 reads a flat list: every entity is placed in the world (MarsSceneLoader.cpp:187-397).
#include "base/files/path.hpp"
#include "flatten/dialect_parts.hpp"

namespace smurf::readings::mars2_file {
namespace {

class EntityReader {
 public:
  explicit EntityReader(const LinkedScene& scene) : scene_(scene) {}

  SceneReading run() {
    find_stop();
    result_.entities.reserve(scene_.instances.size());
    for (const Instance& instance : scene_.instances) result_.entities.push_back(read(instance));
    return std::move(result_);
  }

 private:
  /// The reason why the entity ends the loading of the whole scene; empty if it does not.
  static std::string_view why_it_stops(const Entity& entity) {
    if (entity.position_is_mapping) return "stops at a `position` that is a mapping";
    if (entity.rotation.is_mapping) return "stops at a `rotation` that is a mapping";
    const std::string file = entity.file.value_or({});
    const std::string_view extension = path::extension(file);
    const bool is_known = extension == ".smurf" || extension == ".smurfs" || extension == ".yml";
    return is_known ? std::string_view()
                    : "stops at a `file` that is not a .smurf, .smurfs or "
                      ".yml";
  }

  void find_stop() {
    if (!scene_.scenes.front().document) return;  // a model, opened on its own
    const std::vector<Entity>& entities = scene_.scenes.front().scene.entities;
    for (std::size_t i = 0; i < entities.size(); ++i) {
      if (entities[i].list != EntityList::entities) continue;
      why_stopped_ = why_it_stops(entities[i]);
      if (why_stopped_.empty()) continue;
      stop_ = i;
      return;
    }
  }

  /// The entity of the loaded scene from which an instance comes.
  std::size_t outermost_entity(const Instance& instance) const {
    std::size_t entity = instance.entity;
    const SceneUse* use = &scene_.use(instance);
    while (use->outer) {
      entity = use->including_entity;
      use = &scene_.uses[to_size(*use->outer)];
    }
    return entity;
  }

  EntityReading read(const Instance& instance) {
    const Entity& entity = scene_.entity(instance);
    if (scene_.scenes.front().drawing) return left_out("reads no drawings");
    if (entity.list != EntityList::entities) return left_out("reads no list but `entities`");
    const std::size_t outermost = outermost_entity(instance);
    if (stop_ && outermost == *stop_) return left_out(why_stopped_);
    if (stop_ && outermost > *stop_) return left_out("stopped at an entity before this one");
    if (scene_.use(instance).outer && path::extension(instance.file) != ".yml") {
      return left_out("reads only .yml files in scenes inside a scene");
    }
    if (!instance.X_WE) return {};
    EntityReading reading;
    reading.X_WE = Pose{entity.position.value_or({0, 0, 0}), to_quaternion(entity.rotation)};
    if (instance.placement.parent.kind != Attachment::Kind::none) {
      add_note(reading.note, "ignores `parent`");
    }
    if (entity.anchor && !entity.anchor->empty()) {
      reading.anchor.kind = Attachment::Kind::world;
      if (reading.anchor != instance.placement.anchor) {
        add_note(reading.note, "fixes it to the world");
      }
    }
    if (const LinkedModel* model = scene_.model(instance); model != nullptr && entity.pose) {
      reading.joint_pose = poses_.of(entity, *model, *entity.pose, [&] {
        return positions_of_pose(entity, *model, *entity.pose, joint_of_motor(*model));
      });
    }
    return reading;
  }

  static EntityReading left_out(std::string_view why) {
    EntityReading reading;
    reading.note = why;
    return reading;
  }

  const LinkedScene& scene_;
  std::optional<std::size_t> stop_;
  std::string_view why_stopped_;
  SceneReading result_;
  JointPoseTable poses_{result_.joint_poses};
};

SceneReading read(const LinkedScene& scene) { return EntityReader(scene).run(); }

}  // namespace

extern constinit const Dialect mars2{.name = "mars2",
                                     .help = "as MARS 2 reads it",
                                     .read = read,
                                     .pose_of = documented_pose,
                                     .is_moved_by_include = [](const Entity&) { return false; }};

}  // namespace smurf::readings::mars2_file
