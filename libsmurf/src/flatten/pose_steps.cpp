// SPDX-License-Identifier: BSD-3-Clause
// The way from the world to an instance, transform by transform. The steps multiply to X_WE.
#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "link/scene_link.hpp"
#include "smurf/dialect.hpp"
#include "smurf/flatten.hpp"

namespace smurf {
namespace {

class Explainer {
 public:
  Explainer(const LinkedScene& scene, const Dialect& dialect)
      : scene_(scene), dialect_(dialect), reading_(dialect.read(scene)) {}

  std::vector<TransformStep> run(InstanceIndex instance) {
    if (read(instance).X_WE) add_instance(instance);
    return std::move(steps_);
  }

 private:
  const EntityReading& read(InstanceIndex instance) const {
    return reading_.entities[to_size(instance)];
  }

  bool is_too_long() const { return steps_.size() > kMostSteps; }

  void add(std::string what, Span span, const Pose& X_step) {
    const Pose X_W = steps_.empty() ? X_step : steps_.back().X_W * X_step;
    steps_.push_back({std::move(what), span, X_step, X_W});
  }

  /// Adds the parents of an instance first. Chains of parents have no cycles here, because X_WE is
  /// known.
  void add_instance(InstanceIndex instance) {
    std::vector<InstanceIndex> chain{instance};
    while (read(chain.back()).parent.kind == Attachment::Kind::link) {
      chain.push_back(read(chain.back()).parent.instance);
    }
    for (std::size_t i = chain.size(); i-- > 0 && !is_too_long();) {
      add_includes(scene_.instance(chain[i]));
      add_entity(scene_.instance(chain[i]), *read(chain[i]).X_WE);
      if (i > 0) add_joints(chain[i], read(chain[i - 1]).parent.link);
    }
  }

  /// The includes whose poses an instance inherits, the outermost first.
  void add_includes(const Instance& instance) {
    std::vector<const SceneUse*> includes;
    const Entity* inner = &scene_.entity(instance);
    for (const SceneUse* use = &scene_.use(instance);
         use->outer && dialect_.is_moved_by_include(*inner); use = outer(*use)) {
      includes.push_back(use);
      inner = scene_.entity(*use);
    }
    for (std::size_t i = includes.size(); i-- > 0;) {
      const Entity& entity = *scene_.entity(*includes[i]);
      add("include " + quoted(includes[i]->path), place_of(entity),
          dialect_.pose_of(scene_, *outer(*includes[i]), entity));
    }
  }

  const SceneUse* outer(const SceneUse& use) const { return &scene_.uses[to_size(*use.outer)]; }

  void add_entity(const Instance& instance, const Pose& X_WE) {
    const Entity& entity = scene_.entity(instance);
    Pose X_PE = dialect_.pose_of(scene_, scene_.use(instance), entity);
    const Pose X_WP = steps_.empty() ? Pose{} : steps_.back().X_W;
    // If a dialect uses more than the keys of the scene, the step is the resulting transform.
    if (!is_same_pose(X_WP * X_PE, X_WE)) X_PE = inverse(X_WP) * X_WE;
    add("entity " + quoted(instance.path), written_at(entity), X_PE);
  }

  void add_joints(InstanceIndex instance, const std::string& link) {
    const std::optional<ModelIndex>& index = scene_.instance(instance).model;
    const LinkedModel* model = scene_.model(scene_.instance(instance));
    const JointPoseIndex pose = read(instance).joint_pose;
    const auto& frames = frames_.of(scene_, *index, pose, reading_.joint_poses);
    const JointPositions& positions = reading_.joint_poses[to_size(pose)];
    const auto target = model->link_names.find(link);
    if (!target || *target >= frames.size() || !frames[*target]) return;
    std::vector<JointIndex> joints;
    for (std::size_t at = *target; const auto above = model->tree.parent_joint[at];) {
      joints.push_back(*above);
      at = to_size(*model->tree.joint_parent[to_size(*above)]);
    }
    std::reverse(joints.begin(), joints.end());
    for (const JointIndex joint : joints) {
      if (is_too_long()) return;
      const auto& X_EP = frames[to_size(*model->tree.joint_parent[to_size(joint)])];
      const auto& X_EC = frames[to_size(*model->tree.joint_child[to_size(joint)])];
      add(joint_title(positions, model->joint(joint)), joint_place(model->joint(joint)),
          inverse(*X_EP) * *X_EC);
    }
  }

  static Span joint_place(const urdf::Joint& joint) {
    return joint.name.span.empty() ? joint.span : joint.name.span;
  }

  static std::string joint_title(const JointPositions& positions, const urdf::Joint& joint) {
    std::string title = "joint " + quoted(joint.name.value_or({}));
    const auto position = positions.find(joint.name.value_or({}));
    if (position == positions.end()) return title;
    const bool is_linear = joint.type == urdf::JointType::prismatic;
    return title + " at " + format_rounded(position->second) + (is_linear ? " m" : " rad");
  }

  const LinkedScene& scene_;
  const Dialect& dialect_;
  SceneReading reading_;
  LinkFrames frames_;
  std::vector<TransformStep> steps_;
};

}  // namespace

std::vector<TransformStep> explain(const LinkedScene& scene, InstanceIndex index,
                                   const Dialect& dialect) {
  return Explainer(scene, dialect).run(index);
}

}  // namespace smurf
