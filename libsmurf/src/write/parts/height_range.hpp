// SPDX-License-Identifier: BSD-3-Clause
// The darkest and the brightest value of a height image.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace smurf {

/// Both are 0 for black and 1 for white.
struct HeightRange {
  double darkest = 0, brightest = 0;
  std::uint32_t width = 0, height = 0;  ///< pixels
  bool is_grey = true;                  ///< no pixel has a colour
  std::string fault;  ///< why the image cannot be read: "is damaged"; empty if it can
};

/// Of a PNG file with at most `most` pixels. MuJoCo uses the red part of coloured pixels, and so
/// does this function.
HeightRange height_range(std::string_view png, std::uint64_t most);

}  // namespace smurf
