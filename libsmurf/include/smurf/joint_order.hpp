// SPDX-License-Identifier: BSD-3-Clause
// The order in which a reader builds the joints and bodies of a robot.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"
#include "smurf/readers.hpp"

namespace smurf {

/// The order in which a reader builds the joints and the links of a robot.
struct JointOrder {
  const Reader* reader = nullptr;
  std::string_view walk;   ///< "depth first, the joints of a link as in the file"
  std::string_view basis;  ///< which versions were executed; if the order is unknown: why
  bool is_known = false;   ///< otherwise the lists are empty
  /// Joints that have positions, in the order of the positions.
  std::vector<std::string> joints;
  std::vector<std::size_t> indices;  ///< by entry of `joints`: its index in functions of the reader
  std::vector<std::string> bodies;   ///< in the order of the reader
};

/// What a target, or one of its releases, builds with its own settings. A robot that the reader
/// refuses has an order, too.
JointOrder joint_order(const LinkedModel& model, const Reader& reader);

/// The targets whose orders are known, in the order of the table of readers.
std::vector<const Reader*> readers_with_joint_order();

/// By entry of `to`: its place in `from`, so that values in the order `from` become values in the
/// order `to`: to[i] = from[permutation[i]]. None for names that `from` does not have.
std::vector<std::optional<std::size_t>> permutation(std::span<const std::string> from,
                                                    std::span<const std::string> to);

}  // namespace smurf
