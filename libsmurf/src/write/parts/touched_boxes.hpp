// SPDX-License-Identifier: BSD-3-Clause
// The collision shapes that contact sensors observe, as boxes.
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

/// Boxes by link, in the frames of the links, around the collision shapes plus a margin for
/// contacts. Empty if the size of a shape is unknown, or if there is no shape.
using TouchedBoxes = std::map<std::size_t, Box>;

/// The model has a robot and must outlive this object.
class CollisionBoxes {
 public:
  explicit CollisionBoxes(const LinkedModel& model) : model_(model) {}

  /// The boxes of a contact sensor in <gazebo> on this link: those of the named collision, or of
  /// all collisions if it names none.
  TouchedBoxes of(std::size_t link, std::string_view collision);
  /// The boxes of an annotation. MARS reads its names as those of collisions, Phobos as those
  /// of links. Empty if they name shapes of more than `most` links, or the same shapes many
  /// times.
  TouchedBoxes of(std::vector<std::string> names, std::size_t most);

 private:
  /// The boxes of all collisions with one name, or on one link.
  struct Boxes {
    TouchedBoxes of_links;
    std::set<std::size_t> unknown;  ///< links that have such a shape of unknown size
  };

  void read();
  /// The boxes for a name in an annotation; null if it names nothing.
  const Boxes* find(std::string_view name) const;

  const LinkedModel& model_;
  bool is_read_ = false;
  std::unordered_map<std::string_view, Boxes> by_name_;
  std::vector<Boxes> of_links_;
};

}  // namespace smurf
