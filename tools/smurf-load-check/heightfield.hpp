// SPDX-License-Identifier: BSD-3-Clause
// Height images, read with libpng.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "smurf-load-check/shape_files.hpp"

namespace smurf::load_check {

struct HeightImage {
  std::size_t columns = 0, rows = 0;  ///< at least 2
  std::vector<float> heights;         ///< from the top row; black is 0, white is 1
};

/// The grey values of a PNG file of at most `most` pixels, or the reason why there are none.
std::variant<HeightImage, std::string>
read_height_image(const std::string& path, const ShapeFiles& from, std::uint64_t most);

}  // namespace smurf::load_check
