// SPDX-License-Identifier: BSD-3-Clause
// The largest allowed figures. Calibrated on 132 sound robots at a step of 1 ms.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace smurf::load_check {

struct BoundInfo {
  std::string_view name;  ///< name in --bounds and in reports
  std::string_view unit;
  double limit;
  std::string_view about;
};

inline constexpr std::array<BoundInfo, 9> kBounds = {{
    {"axis", "", 1e-3, "difference of the length of a joint's axis from 1"},
    {"mass-ratio", "", 1e5, "masses of two jointed bodies, the larger by the smaller"},
    {"overlap", "m", 1e-4, "depth of the overlap of two shapes at the start"},
    {"motion", "m", 1e-9, "movement of a link without gravity; a radian counts as a metre"},
    {"gap", "m", 1e-3, "gap between the two sides of a joint while hanging"},
    {"twist", "rad", 1e-2, "angle between the two sides of a joint while hanging"},
    {"hang-energy", "m", 1e-3, "energy gained while hanging, by the weight"},
    {"drop-energy", "m", 0.1, "energy gained while dropping, by the weight"},
    {"anchor", "m", 1e-6, "movement of an anchored root link; a radian counts as a metre"},
}};

class Bounds {
 public:
  Bounds();
  /// Precondition: the name is in kBounds.
  double operator[](std::string_view name) const;
  /// Parses "NAME=VALUE"; returns an error message, or "".
  std::optional<std::string> set(std::string_view assignment);

 private:
  std::array<double, kBounds.size()> limits_{};
};

const BoundInfo& bound_info(std::string_view name);

}  // namespace smurf::load_check
