// SPDX-License-Identifier: BSD-3-Clause
// The frames that sensors of MuJoCo measure: those of bodies, their inertias, sites, shapes and
// cameras.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "mjcf/parts_by_name.hpp"

namespace smurf::mjcf {

struct MeasuredFrame {
  std::uint32_t body = 0;
  Pose X_BF;                   ///< in the frame of the body
  bool has_known_axes = true;  ///< otherwise only its position is right
};

/// The frame that `objtype` and `objname` of a sensor name, or `reftype` and `refname`: `which` is
/// "obj" or "ref". None if it is not known here, or not named.
std::optional<MeasuredFrame> measured_frame(const Model& model, const PartsByName& parts,
                                            const Reference& sensor, std::string_view which,
                                            Reporter& reporter);

}  // namespace smurf::mjcf
