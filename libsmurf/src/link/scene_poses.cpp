// SPDX-License-Identifier: BSD-3-Clause
// Named joint pose sets and world poses. X_WE = X_WP * X_PE, where P may be a link of another
// instance in its own joint pose set.
#include <map>
#include <unordered_map>
#include <utility>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/quantity.hpp"
#include "base/text/edits.hpp"
#include "base/text/quoted.hpp"
#include "link/kinematics.hpp"
#include "link/scene_link.hpp"

namespace smurf {
namespace {

const JointPoseSet* find_set(const std::vector<JointPoseSet>& sets, std::string_view name) {
  for (const JointPoseSet& set : sets) {
    if (set.name && *set.name == name) return &set;
  }
  return nullptr;
}

void report_pose(const Entity& entity, const LinkedModel& model, LoadContext& context) {
  Diagnostic& diagnostic = context.sink.report(rules::sml5105_unknown_pose, entity.pose.span,
                                               "there is no joint pose set `" + *entity.pose +
                                                   "` in `" + model.path + "`");
  if (*entity.pose == "default") {
    diagnostic.severity = Severity::info;
    diagnostic.help("Phobos up to 0.7 writes this name always; the joints stay at zero");
    return;
  }
  constexpr std::size_t kMostSets = 5000;  // the most names that are compared for a suggestion
  if (entity.poses.size() + model.annotations.poses.size() > kMostSets) return;
  std::vector<std::string_view> known;
  for (const auto* sets : {&entity.poses, &model.annotations.poses}) {
    for (const JointPoseSet& set : *sets) {
      if (set.name) known.push_back(*set.name);
    }
  }
  if (const auto near = context.sink.suggest(*entity.pose, known)) {
    const std::string_view written = context.sources.text(entity.pose.span);
    diagnostic.help("did you mean `" + std::string(*near) + "`?");
    diagnostic.fixes.push_back(
        {Applicability::unsafe, {{entity.pose.span, yaml_like(written, *near)}}});
  } else if (known.empty()) {
    diagnostic.help("the model has no section `poses`");
  }
}

/// Instances share equal sets: an entity owns its own set, the model owns all others.
class JointPoses {
 public:
  JointPoses(LoadContext& context, LinkedScene& scene)
      : context_(context), scene_(scene), sets_(scene.models.size()) {}

  void run() {
    for (Instance& instance : scene_.instances) {
      const Entity& entity = scene_.entity(instance);
      const LinkedModel* model = scene_.model(instance);
      if (!entity.pose || entity.pose->empty() || model == nullptr) continue;
      const auto [known, is_new] = of_entity_.try_emplace(&entity);
      if (is_new) known->second = find(entity, *instance.model);
      if (known->second) {
        instance.joint_pose = *known->second;
      } else if (model->is_complete) {
        report_pose(entity, *model, context_);
      }
    }
  }

 private:
  std::optional<JointPoseIndex> find(const Entity& entity, ModelIndex index) {
    const LinkedModel& model = scene_.models[to_size(index)];
    if (const JointPoseSet* own = find_set(entity.poses, *entity.pose)) return add(model, *own);
    const auto known = of_model_.find({index, *entity.pose});
    if (known != of_model_.end()) return known->second;
    const auto& sets = sets_of(index);
    const auto set = sets.find(*entity.pose);
    if (set == sets.end()) return std::nullopt;
    return of_model_[{index, *entity.pose}] = add(model, *set->second);
  }

  JointPoseIndex add(const LinkedModel& model, const JointPoseSet& set) {
    for (const JointPoseSet::Entry& entry : set.joints) {
      if (!entry.position || is_quantity(*entry.position)) continue;
      context_.sink.report(rules::sml4003_out_of_range, entry.position.span,
                           quoted(entry.name.value) +
                               " is so large that no pose can be computed with it");
    }
    const JointPoseIndex index{static_cast<std::uint32_t>(scene_.joint_poses.size())};
    scene_.joint_poses.push_back(to_joint_positions(model, set));
    return index;
  }

  using Sets = std::map<std::string_view, const JointPoseSet*>;

  /// Of several equal names, the first is used.
  const Sets& sets_of(ModelIndex index) {
    std::optional<Sets>& sets = sets_[to_size(index)];
    if (sets) return *sets;
    sets.emplace();
    for (const JointPoseSet& set : scene_.models[to_size(index)].annotations.poses) {
      if (set.name) sets->emplace(*set.name, &set);
    }
    return *sets;
  }

  LoadContext& context_;
  LinkedScene& scene_;
  std::vector<std::optional<Sets>> sets_;  ///< by model
  std::map<std::pair<ModelIndex, std::string_view>, JointPoseIndex> of_model_;
  std::unordered_map<const Entity*, std::optional<JointPoseIndex>> of_entity_;
};

/// Each instance depends on at most one other, so the scene is a forest. A chain is followed to a
/// known pose and composed on the way back, without recursion.
class WorldPoses {
 public:
  WorldPoses(LoadContext& context, LinkedScene& scene)
      : sink_(context.sink),
        scene_(scene),
        most_steps_(kStepsOfInstance * context.limits.instances),
        states_(scene.instances.size(), State::open) {}

  void run() {
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) resolve(i);
    for (Instance& instance : scene_.instances) {
      if (!instance.X_WE || is_usable(*instance.X_WE)) continue;
      instance.X_WE.reset();
      sink_.report(rules::sml4003_out_of_range, place_of(scene_.entity(instance)),
                   quoted(instance.path) + " is so far away that its pose cannot be computed");
    }
  }

 private:
  enum class State : std::uint8_t { open, walking, done };
  static constexpr std::uint64_t kStepsOfInstance = 30;  ///< number of links of a large robot

  std::optional<std::size_t> above(std::size_t index) const {
    const Placement& placement = scene_.instances[index].placement;
    if (placement.parent.kind != Attachment::Kind::link) return std::nullopt;
    return to_size(placement.parent.instance);
  }

  void resolve(std::size_t index) {
    std::vector<std::size_t> chain;
    std::optional<std::size_t> at = index;
    while (at && states_[*at] == State::open) {
      states_[*at] = State::walking;
      chain.push_back(*at);
      at = above(*at);
    }
    if (at && states_[*at] == State::walking) report_cycle(*at);
    while (!chain.empty()) {
      compose(chain.back());
      states_[chain.back()] = State::done;
      chain.pop_back();
    }
  }

  void compose(std::size_t index) {
    Instance& instance = scene_.instances[index];
    const Placement& placement = instance.placement;
    if (!placement.is_known) return;
    if (placement.parent.kind != Attachment::Kind::link) {
      instance.X_WE = placement.X_PE;
      return;
    }
    const Instance& parent = scene_.instance(placement.parent.instance);
    const LinkedModel* model = scene_.model(parent);
    if (!parent.X_WE || model == nullptr) return;
    if (!has_steps(instance)) return;
    const auto link = model->link_names.find(placement.parent.link);
    const std::optional<Pose>& X_RL = frames_.of(scene_, parent)[*link];
    if (X_RL) instance.X_WE = *parent.X_WE * *X_RL * placement.X_PE;
  }

  /// Few scenes place entities at links of large robots that each have a different joint pose.
  bool has_steps(const Instance& instance) {
    if (frames_.steps() <= most_steps_) return true;
    if (std::exchange(is_over_, true)) return false;
    sink_
        .report(
            rules::sml5022_too_many_instances, parent_place(scene_, instance),
            "from here on, entities at links have no pose: the entities before took more than " +
                std::to_string(most_steps_) +
                " poses of links; each joint pose set of a model needs the poses of all its "
                "links")
        .help(raise_limit("instances"));
    return false;
  }

  void report_cycle(std::size_t on_cycle) {
    std::vector<std::size_t> members;
    std::size_t at = on_cycle;
    std::size_t first = on_cycle;
    do {
      members.push_back(at);
      first = std::min(first, at);
      at = *above(at);
    } while (at != on_cycle);
    const Instance& reported = scene_.instances[first];
    Diagnostic& diagnostic =
        sink_.report(rules::sml5104_cyclic_parent, parent_place(scene_, reported),
                     members.size() == 1
                         ? "`" + reported.path + "` is placed relative to itself"
                         : "`" + reported.path +
                               "` is placed relative to something that is placed relative to it");
    constexpr std::size_t kMostLabels = 8;
    for (const std::size_t member : members) {
      Instance& instance = scene_.instances[member];
      instance.placement.is_known = false;
      if (member == first || diagnostic.labels.size() >= kMostLabels) continue;
      diagnostic.label(parent_place(scene_, instance),
                       "`" + instance.path + "` refers to the first one again");
    }
  }

  DiagnosticSink& sink_;
  LinkedScene& scene_;
  LinkFrames frames_;
  std::uint64_t most_steps_;
  bool is_over_ = false;
  std::vector<State> states_;
};

}  // namespace

const std::vector<std::optional<Pose>>& LinkFrames::of(const LinkedScene& scene,
                                                       const Instance& instance) {
  if (!instance.model) return none_;
  return of(scene, *instance.model, instance.joint_pose, scene.joint_poses);
}

const std::vector<std::optional<Pose>>& LinkFrames::of(const LinkedScene& scene, ModelIndex model,
                                                       JointPoseIndex pose,
                                                       const std::vector<JointPositions>& poses) {
  // Many large models in many poses would need gigabytes; few scenes have that many links.
  constexpr std::size_t kMostKept = 1'000'000;
  const auto known = frames_.find({model, pose});
  if (known != frames_.end()) return known->second;
  if (kept_ > kMostKept) {
    frames_.clear();
    kept_ = 0;
  }
  std::vector<std::optional<Pose>>& frames = frames_[{model, pose}];
  frames = forward_kinematics(scene.models[to_size(model)], poses[to_size(pose)]);
  kept_ += frames.size();
  steps_ += steps_of_kinematics(scene.models[to_size(model)]);
  return frames;
}

void resolve_joint_poses(LoadContext& context, LinkedScene& scene) {
  JointPoses(context, scene).run();
}

Span parent_place(const LinkedScene& scene, const Instance& instance) {
  const Entity* entity = &scene.entity(instance);
  for (std::optional<UseIndex> use = instance.use; use;) {
    if (entity->parent && entity->parent->find("::") != std::string::npos) {
      return entity->parent.span;
    }
    entity = scene.entity(scene.uses[to_size(*use)]);
    use = scene.uses[to_size(*use)].outer;
  }
  return {};
}

void compose_world_poses(LoadContext& context, LinkedScene& scene) {
  WorldPoses(context, scene).run();
}

}  // namespace smurf
