// SPDX-License-Identifier: BSD-3-Clause
// Word wrap.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf::render {

/// Breaks the text at spaces into lines of at most `columns`, each after `indent` spaces; a longer
/// word has a line of its own. A line end in the text is kept. Ends with a line end.
std::string wrap(std::string_view text, std::size_t indent, std::size_t columns);

}  // namespace smurf::render
