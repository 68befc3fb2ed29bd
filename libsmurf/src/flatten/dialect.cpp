// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/dialect.hpp"

#include <algorithm>
#include <cmath>

#include "base/findings/rules.hpp"
#include "base/numbers/quantity.hpp"
#include "base/text/quoted.hpp"
#include "flatten/dialect_parts.hpp"

namespace smurf {

namespace readings {
#define SMURF_DIALECT(name)                                                                        \
  namespace name##_file {                                                                          \
    extern const Dialect name;                                                                     \
  }                                                                                                \
  using name##_file::name;
#include "flatten/dialects.def"
#undef SMURF_DIALECT
}  // namespace readings

namespace {

constexpr const Dialect* kDialects[] = {
#define SMURF_DIALECT(variable) &readings::variable,
#include "flatten/dialects.def"
#undef SMURF_DIALECT
};

}  // namespace

std::span<const Dialect* const> dialects() { return kDialects; }

const Dialect* find_dialect(std::string_view name) {
  for (const Dialect* dialect : kDialects) {
    if (dialect->name == name) return dialect;
  }
  return nullptr;
}

SceneReading read_as(const Dialect& dialect, const LinkedScene& scene, DiagnosticSink& sink) {
  SceneReading read = dialect.read(scene);
  for (std::size_t i = 0; i < read.entities.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (!instance.X_WE || read.entities[i].X_WE) continue;
    sink.report(rules::sml8208_not_in_dialect, place_of(scene.entity(instance)),
                quoted(instance.path) + " is not in the scene of the dialect " +
                    std::string(dialect.name) + ", which " + read.entities[i].note);
  }
  return read;
}

bool is_same_pose(const std::optional<Pose>& a, const std::optional<Pose>& b) {
  if (!a || !b) return !a && !b;
  constexpr double kSame = 1e-9;  // m and rad: the promised accuracy
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::fabs(a->position[i] - b->position[i]) <= kSame)) return false;
  }
  return angle_between(a->orientation, b->orientation) <= kSame;
}

JointOfEntry joint_of_motor(const LinkedModel& model) {
  return [&model](const std::string& entry) -> std::optional<std::string> {
    const auto motor = model.motor_names.find(entry);
    if (!motor) return std::nullopt;
    return model.annotations.motors[*motor].joint.value();
  };
}

JointPositions positions_of_pose(const Entity& entity, const LinkedModel& model,
                                 std::string_view pose, const JointOfEntry& joint_of_entry) {
  JointPositions positions;
  for (const auto* sets : {&entity.poses, &model.annotations.poses}) {
    for (const JointPoseSet& set : *sets) {
      if (set.name.value_or({}) != pose) continue;
      for (const JointPoseSet::Entry& entry : set.joints) {
        if (!entry.position || !is_quantity(*entry.position)) continue;
        if (auto joint = joint_of_entry(entry.name.value)) {
          positions[std::move(*joint)] = *entry.position;
        }
      }
    }
  }
  return positions;
}

/// An entity may have many instances.
bool JointPoseTable::has_own(const Entity& entity, std::string_view pose) {
  if (entity.poses.empty()) return false;
  const auto [known, is_new] = has_own_.try_emplace({&entity, std::string(pose)});
  if (is_new) {
    known->second =
        std::any_of(entity.poses.begin(), entity.poses.end(),
                    [&](const JointPoseSet& set) { return set.name.value_or({}) == pose; });
  }
  return known->second;
}

JointPoseIndex JointPoseTable::of(const Entity& entity, const LinkedModel& model,
                                  std::string_view pose,
                                  const std::function<JointPositions()>& read) {
  const Entity* owner = has_own(entity, pose) ? &entity : nullptr;
  const auto [known, is_new] = known_.try_emplace({&model, owner, std::string(pose)});
  if (is_new) {
    known->second = JointPoseIndex{static_cast<std::uint32_t>(poses_.size())};
    poses_.push_back(read());
  }
  return known->second;
}

std::optional<Pose> link_frame(const LinkedScene& scene, const SceneReading& reading,
                               InstanceIndex instance, std::string_view link, LinkFrames& frames) {
  const Instance& target = scene.instance(instance);
  const LinkedModel* model = scene.model(target);
  if (model == nullptr || !model->robot) return std::nullopt;
  const auto index = model->link_names.find(link);
  if (!index) return std::nullopt;
  return frames.of(scene, *target.model, reading.entities[to_size(instance)].joint_pose,
                   reading.joint_poses)[*index];
}

Pose documented_pose(const LinkedScene& /*scene*/, const SceneUse& /*use*/, const Entity& entity) {
  return {entity.position.value_or({0, 0, 0}), to_quaternion(entity.rotation)};
}

bool has_no_parent_link(const Entity& entity) {
  return !entity.parent || entity.parent->find("::") == std::string::npos;
}

void add_note(std::string& note, std::string_view text) {
  note += (note.empty() ? "" : ", ") + std::string(text);
}

Span written_at(const Entity& entity) {
  const Span place = place_of(entity);
  return place.source == entity.span.source ? place : entity.span;
}

}  // namespace smurf
