// SPDX-License-Identifier: BSD-3-Clause
// The name of a text from standard input to which the user gives none.
#pragma once

#include <string_view>

namespace smurf {

/// Without its extension, which says what the text is: "stdin.urdf".
inline constexpr std::string_view kStandardInput = "stdin";

inline bool is_standard_input(std::string_view path) {
  return path.starts_with(kStandardInput) && path.substr(kStandardInput.size()).starts_with('.') &&
         path.find('/') == std::string_view::npos;
}

}  // namespace smurf
