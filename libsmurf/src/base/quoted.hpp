// SPDX-License-Identifier: BSD-3-Clause
// Texts of files inside messages. A hostile name has millions of bytes, a message must not.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf {

/// At most `most` bytes and a few: the middle of what is longer is left out.
std::string shortened(std::string_view text, std::size_t most);

/// As messages show what is written: in backquotes, shortened.
std::string quoted(std::string_view text);

}  // namespace smurf
