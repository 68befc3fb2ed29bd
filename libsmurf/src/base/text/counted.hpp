// SPDX-License-Identifier: BSD-3-Clause
// Counts in sentences: "1 joint", "7 joints".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf {

/// "1 entry", "7 entries".
inline std::string counted(std::size_t number, std::string_view singular, std::string_view plural) {
  return std::to_string(number) + " " + std::string(number == 1 ? singular : plural);
}

/// "1 joint", "7 joints".
inline std::string counted(std::size_t number, std::string_view noun) {
  return counted(number, noun, std::string(noun) + "s");
}

}  // namespace smurf
