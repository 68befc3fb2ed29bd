// SPDX-License-Identifier: BSD-3-Clause
// Named joint pose sets and world poses. X_WE = X_WP * X_PE, where P may be a link of another
// instance in its own joint pose set.
#include "base/edits.hpp"
#include "base/rules.hpp"
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
    diagnostic.help = "Phobos up to 0.7 writes this name always; the joints stay at zero";
    return;
  }
  constexpr std::size_t kMostSets = 5000;  // more are not searched for a near name
  if (entity.poses.size() + model.annotations.poses.size() > kMostSets) return;
  std::vector<std::string_view> known;
  for (const auto* sets : {&entity.poses, &model.annotations.poses}) {
    for (const JointPoseSet& set : *sets) {
      if (set.name) known.push_back(*set.name);
    }
  }
  if (const auto near = context.sink.suggest(*entity.pose, known)) {
    const std::string_view written = context.sources.text(entity.pose.span);
    diagnostic.help = "did you mean `" + std::string(*near) + "`?";
    diagnostic.fixes.push_back(
        {Applicability::unsafe, {{entity.pose.span, yaml_like(written, *near)}}});
  } else if (known.empty()) {
    diagnostic.help = "the model has no section `poses`";
  }
}

/// Each instance hangs below at most one other, so the scene is a forest; a chain is walked up to
/// something known and composed on the way back, without recursion.
class WorldPoses {
 public:
  WorldPoses(LoadContext& context, LinkedScene& scene)
      : sink_(context.sink), scene_(scene), states_(scene.instances.size(), State::open) {}

  void run() {
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) resolve(i);
  }

 private:
  enum class State : std::uint8_t { open, walking, done };

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
    const auto link = model->link_names.find(placement.parent.link);
    const std::optional<Pose>& X_RL = frames_.of(scene_, parent)[*link];
    if (X_RL) instance.X_WE = *parent.X_WE * *X_RL * placement.X_PE;
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
                     members.size() == 1 ? "`" + reported.path + "` is placed relative to itself"
                                         : "`" + reported.path +
                                               "` is placed relative to something that is "
                                               "placed relative to it");
    constexpr std::size_t kMostLabels = 8;
    for (const std::size_t member : members) {
      Instance& instance = scene_.instances[member];
      instance.placement.is_known = false;
      if (member == first || diagnostic.labels.size() >= kMostLabels) continue;
      diagnostic.labels.push_back(
          {parent_place(scene_, instance), "`" + instance.path + "` refers back from here"});
    }
  }

  DiagnosticSink& sink_;
  LinkedScene& scene_;
  LinkFrames frames_;
  std::vector<State> states_;
};

}  // namespace

const std::vector<std::optional<Pose>>& LinkFrames::of(const LinkedScene& scene,
                                                       const Instance& instance) {
  return instance.model ? of(scene, *instance.model, instance.joint_positions) : none_;
}

const std::vector<std::optional<Pose>>& LinkFrames::of(const LinkedScene& scene, ModelIndex model,
                                                       const JointPositions& positions) {
  const auto known = frames_.find(std::pair(model, positions));
  if (known != frames_.end()) return known->second;
  return frames_[{model, positions}] = forward_kinematics(scene.models[to_size(model)], positions);
}

void resolve_joint_poses(LoadContext& context, LinkedScene& scene) {
  for (Instance& instance : scene.instances) {
    const Entity& entity = scene.entity(instance);
    const LinkedModel* model = scene.model(instance);
    if (!entity.pose || entity.pose->empty() || model == nullptr) continue;
    if (const JointPoseSet* own = find_set(entity.poses, *entity.pose)) {
      instance.joint_positions = to_joint_positions(*model, *own);
    } else if (auto positions = joint_positions(*model, *entity.pose)) {
      instance.joint_positions = std::move(*positions);
    } else if (model->is_complete) {
      report_pose(entity, *model, context);
    }
  }
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
