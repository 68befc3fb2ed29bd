// SPDX-License-Identifier: BSD-3-Clause
// Computes the size of a scene when it is written out: a small file can name a large one many
// times.
#include <algorithm>
#include <unordered_map>

#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/edits.hpp"
#include "smurf/flatten.hpp"

namespace smurf {
namespace {

class SizeCheck {
 public:
  SizeCheck(const LinkedScene& scene, const SourceMap& sources, const FlattenOptions& options,
            const Limits& limits)
      : scene_(scene),
        sources_(sources),
        options_(options),
        most_(limits.scene_bytes),
        of_model_(scene.models.size()),
        of_pose_(scene.joint_poses.size()) {}

  /// The first entity that exceeds the limit; null if there is none.
  const Entity* run() {
    for (const SceneUse& use : scene_.uses) {
      total_ += world_of(scene_.file(use));
      if (total_ > most_) return use.outer ? scene_.entity(use) : first_entity();
    }
    for (const Instance& instance : scene_.instances) {
      total_ += of(instance);
      if (total_ > most_) return &scene_.entity(instance);
    }
    return nullptr;
  }

 private:
  const Entity* first_entity() const {
    const std::vector<Entity>& entities = scene_.scenes.front().scene.entities;
    return entities.empty() ? nullptr : &entities.front();
  }

  /// Lights are repeated for each use of their scene.
  std::uint64_t world_of(const SceneFile& file) {
    const auto [known, is_new] = of_world_.try_emplace(&file);
    if (!is_new || !file.document) return known->second;
    for (const Light& light : file.scene.lights) {
      known->second += bytes_of({*file.document, light.node});
    }
    return known->second;
  }

  std::uint64_t of(const Instance& instance) {
    std::uint64_t bytes = instance.path.size() + instance.name.size() + instance.type.size() +
                          instance.file.size() + of(scene_.entity(instance), instance) +
                          of(instance.placement.parent) + of(instance.placement.anchor) +
                          of_pose(instance.joint_pose);
    if (instance.model) {
      if (options_.links || options_.repeats_models) {
        const ModelSize& model = of_model(*instance.model);
        bytes += model.bytes + model.names * 2 * escape_xml(instance.path).size();
      }
    } else if (options_.old_scenes != nullptr) {
      bytes += of_old_scene(instance.file);
    }
    return bytes;
  }

  std::uint64_t of(const Attachment& attachment) const {
    if (attachment.kind != Attachment::Kind::link) return 0;
    return scene_.instance(attachment.instance).path.size() + attachment.link.size();
  }

  /// The size of the keys of an entity, which are the same in each use of its scene.
  std::uint64_t of(const Entity& entity, const Instance& instance) {
    const SceneFile& file = scene_.file(scene_.use(instance));
    if (!file.document || (instance.model && entity.extra.empty())) return 0;
    const auto [known, is_new] = of_entity_.try_emplace(&entity);
    if (!is_new) return known->second;
    if (!instance.model) return known->second = bytes_of({*file.document, entity.node});
    for (const CustomSection& key : entity.extra) {
      known->second += bytes_of({*file.document, key.node});
      if (known->second > most_) break;
    }
    return known->second;
  }

  /// The memory for a value, including aliases. The walk ends when it is too much.
  std::uint64_t bytes_of(yaml::View value) const {
    constexpr std::uint64_t kNode = 40;
    std::uint64_t bytes = kNode + value.key().size() + value.text().size();
    for (const yaml::View child : value) {
      if (bytes > most_) break;
      bytes += bytes_of(child);
    }
    return bytes;
  }

  std::uint64_t of_pose(JointPoseIndex index) {
    std::optional<std::uint64_t>& known = of_pose_[to_size(index)];
    if (known) return *known;
    constexpr std::uint64_t kNumber = 40;
    known = 0;
    for (const auto& [joint, position] : scene_.joint_poses[to_size(index)]) {
      *known += kNumber + joint.size();
    }
    return *known;
  }

  /// `names`: some formats write the path of the entity before each name.
  using ModelSize = RepeatedParts;

  /// Formats write some hundred bytes for the shortest link or shape, plus the text from the URDF.
  const ModelSize& of_model(ModelIndex index) {
    std::optional<ModelSize>& known = of_model_[to_size(index)];
    if (known) return *known;
    constexpr std::uint64_t kPart = 400;
    const LinkedModel& model = scene_.models[to_size(index)];
    known.emplace();
    if (!model.robot) return *known;
    if (options_.repeated_parts != nullptr) known = options_.repeated_parts(model);
    std::uint64_t parts = 0;
    for (const urdf::Link& link : model.robot->links) {
      parts += 1 + link.visuals.size() + link.collisions.size();
    }
    known->bytes +=
        std::max<std::uint64_t>(kPart * parts, sources_.text(model.robot->document.source).size());
    known->names = std::max<std::uint64_t>(known->names,
                                           model.robot->links.size() + model.robot->joints.size());
    return *known;
  }

  /// A node of some 60 bytes becomes a shape of 200.
  std::uint64_t of_old_scene(const std::string& file) const {
    const auto found = options_.old_scenes->find(file);
    if (found == options_.old_scenes->end()) return 0;
    const OldSceneFile& old = found->second;
    constexpr std::uint64_t kGrowth = 4;
    if (old.xml) return kGrowth * sources_.text(old.xml->source).size();
    return old.yaml ? kGrowth * sources_.text(old.yaml->source).size() : 0;
  }

  const LinkedScene& scene_;
  const SourceMap& sources_;
  const FlattenOptions& options_;
  std::uint64_t most_;
  std::uint64_t total_ = 0;
  std::vector<std::optional<ModelSize>> of_model_;
  std::vector<std::optional<std::uint64_t>> of_pose_;
  std::unordered_map<const Entity*, std::uint64_t> of_entity_;
  std::unordered_map<const SceneFile*, std::uint64_t> of_world_;
};

}  // namespace

bool check_scene_size(const LinkedScene& scene, const SourceMap& sources,
                      const FlattenOptions& options, const Limits& limits, DiagnosticSink& sink) {
  const Entity* last = SizeCheck(scene, sources, options, limits).run();
  if (last == nullptr) return true;
  sink.report(rules::sml5022_too_many_instances, place_of(*last),
              "with this entity the scene, written out, has more than " +
                  std::to_string(limits.scene_bytes) + " bytes")
      .help(raise_limit("scene-bytes"));
  return false;
}

}  // namespace smurf
