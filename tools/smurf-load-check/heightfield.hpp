// SPDX-License-Identifier: BSD-3-Clause
// Images of heights, read by libpng.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "smurf-load-check/shape_files.hpp"

namespace smurf::load_check {

struct HeightImage {
  std::size_t columns = 0, rows = 0;  ///< at least 2
  std::vector<float> heights;         ///< from the top row on; black 0, white 1
};

/// The grey values of a PNG file, or why there are none. It may have `most` pixels.
std::variant<HeightImage, std::string>
read_height_image(const std::string& path, const ShapeFiles& from, std::uint64_t most);

}  // namespace smurf::load_check
