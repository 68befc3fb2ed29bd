// SPDX-License-Identifier: BSD-3-Clause
// The masses of a robot beside the volumes of its shapes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// A link as a body. Values that are not written or not known are absent.
struct LinkMass {
  std::string link;
  std::optional<double> mass;      ///< kg
  std::optional<double> volume;    ///< of its shapes, m3
  bool is_box = false;             ///< the volume is that of the box around the shapes
  std::optional<double> density;   ///< kg/m3
  std::optional<double> gyration;  ///< about the axis of the largest moment, m
  /// The rules about inertials (SML15) that report this link, by id.
  std::vector<const Rule*> reported;
};
/// In the order of the file.
std::vector<LinkMass> masses_of(const LinkedModel& model);

}  // namespace smurf
