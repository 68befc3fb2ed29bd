// SPDX-License-Identifier: BSD-3-Clause
// The collision shapes whose contacts sensors feel, as boxes.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// Boxes by links, in the frames of the links, around the collision shapes and a margin for
/// contacts. Empty when the size of a shape is not known, or when there is no shape.
using TouchedBoxes = std::map<std::size_t, Box>;

/// The model has a robot and outlives this.
class CollisionBoxes {
 public:
  explicit CollisionBoxes(const LinkedModel& model) : model_(model) {}

  /// The boxes that a contact sensor in <gazebo> on this link touches: those of the collision that
  /// it names, or all of the link if it names none.
  TouchedBoxes of(std::size_t link, std::string_view collision);
  /// The boxes that an annotation names. MARS reads its names as those of collisions, and Phobos as
  /// those of links. Empty when they name shapes of more than `most` links, or the same shapes many
  /// times.
  TouchedBoxes of(std::vector<std::string> names, std::size_t most);

 private:
  /// The boxes of all collisions that have one name, or that are on one link.
  struct Boxes {
    TouchedBoxes of_links;
    std::set<std::size_t> unknown;  ///< links that have such a shape of unknown size
  };

  void read();
  /// The boxes of a name in an annotation; null when it names nothing.
  const Boxes* find(std::string_view name) const;

  const LinkedModel& model_;
  bool is_read_ = false;
  std::unordered_map<std::string_view, Boxes> by_name_;
  std::vector<Boxes> of_links_;
};

}  // namespace smurf
