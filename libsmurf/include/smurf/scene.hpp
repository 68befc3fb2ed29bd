// SPDX-License-Identifier: BSD-3-Clause
// A SMURF scene or assembly as written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "smurf/model.hpp"
#include "smurf/pose.hpp"
#include "smurf/source.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// The list an entity stands in; all three may coexist in MARS.
enum class EntityList : std::uint8_t { smurfs, entities, smurfa };

/// How a rotation is written. The numbers keep the order of the file.
enum class RotationForm : std::uint8_t {
  absent,
  yaw,         ///< a number or a list of one: degrees about z
  euler,       ///< list of three: degrees about fixed x, then y, then z
  quaternion,  ///< list of four, or a mapping: w, x, y, z
  invalid      ///< reported; no rotation
};

struct Rotation {
  RotationForm form = RotationForm::absent;
  Span span;
  std::vector<double> values;  ///< yaw: 1, euler: 3, quaternion: 4 as w, x, y, z; not normalised
  bool is_mapping = false;
};

/// One entry of a scene. `path` of the YAML node gives keys that are not listed here.
struct Entity {
  EntityList list = EntityList::entities;
  std::size_t index = 0;  ///< in its list
  Span span;
  yaml::NodeId node = yaml::kNoNode;
  Field<std::string> name, file, type, parent, anchor, pose;
  Field<std::string> uri;
  Field<Vector3> position;  ///< metres, in the frame of the parent
  bool position_is_mapping = false;
  Rotation rotation;
  Field<bool> root;
  std::vector<CustomSection> extra;  ///< every other key
};

struct Physics {
  Field<Vector3> gravity;   ///< m/s^2
  Field<double> step_size;  ///< `ode.stepsize`, milliseconds in MARS
  Field<double> cfm, erp;
};

struct Scene {
  std::vector<Entity> entities;  ///< in MARS's order: `smurfs`, `entities`, `smurfa`
  Physics physics;
  yaml::NodeId physics_node = yaml::kNoNode;
  yaml::NodeId environment = yaml::kNoNode;
  std::vector<Light> lights;
  std::vector<CustomSection> extra;
};

}  // namespace smurf
