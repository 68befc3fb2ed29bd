// SPDX-License-Identifier: BSD-3-Clause
// Counts in sentences: "1 joint", "7 joints".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf {

/// "1 joint", "7 joints".
inline std::string counted(std::size_t number, std::string_view noun) {
  return std::to_string(number) + " " + std::string(noun) + (number == 1 ? "" : "s");
}

}  // namespace smurf
