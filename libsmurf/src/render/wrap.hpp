// SPDX-License-Identifier: BSD-3-Clause
// Word wrap.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf::render {

/// Sentences in reports are wrapped at this column, whatever the width of the terminal.
inline constexpr std::size_t kColumns = 80;

/// Breaks the text at spaces into lines of at most `columns`, each indented by `indent` spaces; a
/// longer word gets a separate line. Keeps line ends of the text. Ends with a line end.
std::string wrap(std::string_view text, std::size_t indent, std::size_t columns);

}  // namespace smurf::render
