// SPDX-License-Identifier: BSD-3-Clause
// Quotes texts of files in messages, shortened: a hostile name can have millions of bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf {

/// At most about `most` bytes: omits the middle of a longer text.
std::string shortened(std::string_view text, std::size_t most);

/// A text as messages show it: shortened and in backquotes.
std::string quoted(std::string_view text);
/// The namespace of std::string has std::quoted(), which is the better match without this.
inline std::string quoted(const std::string& text) { return quoted(std::string_view(text)); }
inline std::string quoted(const char* text) { return quoted(std::string_view(text)); }

}  // namespace smurf
