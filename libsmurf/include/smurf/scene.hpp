// SPDX-License-Identifier: BSD-3-Clause
// A SMURF scene or assembly as written.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "smurf/model.hpp"
#include "smurf/pose.hpp"
#include "smurf/source.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// The list that contains an entity; all three may coexist in MARS.
enum class EntityList : std::uint8_t { smurfs, entities, smurfa };

/// How a rotation is written.
enum class RotationForm : std::uint8_t {
  absent,
  yaw,         ///< a number or a list of one: degrees about z
  euler,       ///< list of three: degrees about fixed x, then y, then z
  quaternion,  ///< list of four, or a mapping: w, x, y, z
  invalid      ///< reported; no rotation
};

/// The rotation of an entity as it is written.
struct Rotation {
  RotationForm form = RotationForm::absent;
  Span span;
  std::array<double, 4> values{};  ///< yaw: 1, euler: 3, quaternion: w, x, y, z; not normalised
  bool is_mapping = false;
};
/// The rotation as a unit quaternion; the identity when it is absent or invalid.
Quaternion to_quaternion(const Rotation& rotation);

/// One entry of a scene.
struct Entity {
  EntityList list = EntityList::entities;
  Span span;
  Span head;  ///< its first key, for findings about the whole
  yaml::NodeId node = yaml::kNoNode;
  Field<std::string> name, file, type, parent, anchor, pose;
  Field<std::string> uri;
  Field<Vector3> position;  ///< metres, in the frame of the parent
  bool position_is_mapping = false;
  Rotation rotation;
  Field<bool> root;
  std::vector<JointPoseSet> poses;   ///< of this entity; MARS puts them before those of the model
  std::vector<CustomSection> extra;  ///< every key without a member above
};

/// The place of a finding about the whole entity: its name, else its first key.
Span place_of(const Entity& entity);

/// Settings of the simulation.
struct Physics {
  Span span;
  yaml::NodeId node = yaml::kNoNode;
  Field<Vector3> gravity;   ///< m/s^2
  Field<double> step_size;  ///< `ode.stepsize`, milliseconds in MARS
  Field<double> cfm, erp;
};

/// A scene file: its entities and its world.
struct Scene {
  std::vector<Entity> entities;  ///< in MARS's order: `smurfs`, `entities`, `smurfa`
  std::optional<Physics> physics;
  yaml::NodeId environment = yaml::kNoNode;
  std::vector<Light> lights;  ///< in the world frame
  std::vector<CustomSection> extra;
};

}  // namespace smurf
