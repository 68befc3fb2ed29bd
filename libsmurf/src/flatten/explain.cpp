// SPDX-License-Identifier: BSD-3-Clause
// The way from the world to an instance, transform by transform. The steps multiply to X_WE.
#include <algorithm>

#include "base/numbers.hpp"
#include "link/scene_link.hpp"
#include "smurf/flatten.hpp"

namespace smurf {
namespace {

std::string quoted(std::string_view name) { return "`" + std::string(name) + "`"; }

class Explainer {
 public:
  explicit Explainer(const LinkedScene& scene) : scene_(scene) {}

  std::vector<TransformStep> run(const Instance& instance) {
    add_instance(instance);
    return std::move(steps_);
  }

 private:
  void add(std::string what, Span span, const Pose& X_step) {
    const Pose X_W = steps_.empty() ? X_step : steps_.back().X_W * X_step;
    steps_.push_back({std::move(what), span, X_step, X_W});
  }

  /// The parents of an instance first. Chains of parents have no cycles here, since X_WE is known.
  void add_instance(const Instance& instance) {
    std::vector<const Instance*> chain{&instance};
    while (chain.back()->placement.parent.kind == Attachment::Kind::link) {
      chain.push_back(&scene_.instance(chain.back()->placement.parent.instance));
    }
    for (std::size_t i = chain.size(); i-- > 0;) {
      add_includes(*chain[i]);
      add_entity(*chain[i]);
      if (i > 0) add_joints(*chain[i], chain[i - 1]->placement.parent.link);
    }
  }

  static bool has_own_parent(const Placement& own, const Entity& entity) {
    return own.parent.kind == Attachment::Kind::link && entity.parent &&
           entity.parent->find("::") != std::string::npos;
  }

  /// The includes whose poses an instance inherits, outermost first.
  void add_includes(const Instance& instance) {
    if (has_own_parent(instance.placement, scene_.entity(instance))) return;
    std::vector<const SceneUse*> includes;
    for (const SceneUse* use = &scene_.use(instance); use->outer;
         use = &scene_.uses[to_size(*use->outer)]) {
      includes.push_back(use);
      if (has_own_parent(use->placement, *scene_.entity(*use))) break;
    }
    for (std::size_t i = includes.size(); i-- > 0;) {
      const Entity& entity = *scene_.entity(*includes[i]);
      add("include " + quoted(includes[i]->path), place_of(entity), own_pose(entity));
    }
  }

  void add_entity(const Instance& instance) {
    const Entity& entity = scene_.entity(instance);
    add("entity " + quoted(instance.path), place_of(entity), own_pose(entity));
  }

  static Pose own_pose(const Entity& entity) {
    return {entity.position.value_or({0, 0, 0}), to_quaternion(entity.rotation)};
  }

  void add_joints(const Instance& instance, const std::string& link) {
    const LinkedModel* model = scene_.model(instance);
    const auto& frames = frames_.of(scene_, instance);
    const auto target = model->link_names.find(link);
    if (!target || *target >= frames.size() || !frames[*target]) return;
    std::vector<JointIndex> joints;
    for (std::size_t at = *target; const auto above = model->tree.parent_joint[at];) {
      joints.push_back(*above);
      at = to_size(*model->tree.joint_parent[to_size(*above)]);
    }
    std::reverse(joints.begin(), joints.end());
    for (const JointIndex joint : joints) {
      const auto& X_EP = frames[to_size(*model->tree.joint_parent[to_size(joint)])];
      const auto& X_EC = frames[to_size(*model->tree.joint_child[to_size(joint)])];
      add(joint_title(instance, model->joint(joint)), joint_place(model->joint(joint)),
          inverse(*X_EP) * *X_EC);
    }
  }

  static Span joint_place(const urdf::Joint& joint) {
    return joint.name.span.empty() ? joint.span : joint.name.span;
  }

  static std::string joint_title(const Instance& instance, const urdf::Joint& joint) {
    std::string title = "joint " + quoted(joint.name.value_or({}));
    const auto position = instance.joint_positions.find(joint.name.value_or({}));
    if (position == instance.joint_positions.end()) return title;
    const bool is_linear = joint.type == urdf::JointType::prismatic;
    return title + " at " + format_rounded(position->second) + (is_linear ? " m" : " rad");
  }

  const LinkedScene& scene_;
  LinkFrames frames_;
  std::vector<TransformStep> steps_;
};

}  // namespace

std::vector<TransformStep> explain(const LinkedScene& scene, InstanceIndex index) {
  const Instance& instance = scene.instance(index);
  if (!instance.X_WE) return {};
  return Explainer(scene).run(instance);
}

}  // namespace smurf
