// SPDX-License-Identifier: BSD-3-Clause
// The collision shapes whose contacts sensors feel, as boxes.
#pragma once

#include <map>
#include <optional>
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

  /// Of a contact sensor in <gazebo> on this link: of the collision that it names, otherwise of all
  /// of the link.
  TouchedBoxes of(std::size_t link, std::string_view collision);
  /// Of an annotation: names of collisions, as MARS reads them, or of links, as Phobos does.
  TouchedBoxes of(const std::vector<std::string>& names);

 private:
  using OfLink = std::pair<std::size_t, std::optional<Box>>;

  void read();

  const LinkedModel& model_;
  bool is_read_ = false;
  std::unordered_multimap<std::string_view, OfLink> by_name_;
  std::vector<std::optional<Box>> of_links_;  ///< none: without shape, or of unknown size
};

}  // namespace smurf
