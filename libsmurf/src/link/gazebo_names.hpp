// SPDX-License-Identifier: BSD-3-Clause
// The names that libsdformat gives to collisions when it converts a URDF. It merges links that are
// fixed to each other.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// Whether sdformat 12.3 reads a flag as set: in any case (run).
bool is_set_for_gazebo(xml::View flag);

/// The names of the fixed joints that sdformat does not merge.
std::set<std::string_view> joints_kept_by_gazebo(const LinkedModel& model);

struct GazeboNames {
  /// By link: the link that libsdformat merges it into, which may be itself.
  std::vector<std::size_t> bodies;
  /// By link and collision; "" for a link without a place in the tree.
  std::vector<std::vector<std::string>> collisions;
};

/// The name of a collision in the URDF; "" if it has none.
using NameOfCollision = std::function<std::string(std::size_t link, std::size_t collision)>;

/// libsdformat 12.3, parser_urdf.cc: ReduceFixedJoints, ReduceCollisionsToParent, CreateCollisions,
/// CreateCollision. `name_of` replaces the names of the URDF if it is given.
GazeboNames gazebo_names(const LinkedModel& model, const NameOfCollision& name_of = {});

/// A text of a contact sensor that names a collision, and the link that the sensor belongs to.
struct ContactName {
  xml::View element;  ///< <collision>
  std::string text;
  std::size_t link = 0;
};
/// Those in the <gazebo> elements of the URDF, whose references are links.
std::vector<ContactName> contact_names(const LinkedModel& model);

struct CollisionPlace {
  std::size_t link = 0, collision = 0;
};
/// The collision with this name in the body that a link is merged into; none if there is none.
std::optional<CollisionPlace> find_collision(const GazeboNames& names, std::size_t link,
                                             std::string_view name);

}  // namespace smurf
