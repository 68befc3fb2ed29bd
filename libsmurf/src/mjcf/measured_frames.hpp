// SPDX-License-Identifier: BSD-3-Clause
// The frames that sensors of MuJoCo measure: those of bodies, their inertias, sites, shapes and
// cameras.
#pragma once

#include <cstdint>
#include <optional>

#include "mjcf/parts_by_name.hpp"

namespace smurf::mjcf {

struct MeasuredFrame {
  std::uint32_t body = 0;
  Pose X_BF;                   ///< in the frame of the body
  bool has_known_axes = true;  ///< otherwise only its position is right
};

/// The frame that `objtype` and `objname` of a sensor name; none if it is measured relative to
/// another frame (`reftype`), or is not known here.
std::optional<MeasuredFrame> measured_frame(const Model& model, const PartsByName& parts,
                                            const Reference& sensor, Reporter& reporter);

}  // namespace smurf::mjcf
