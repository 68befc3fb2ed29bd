// SPDX-License-Identifier: BSD-3-Clause
// Byte-range edits of a text: all other bytes stay identical.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Applies edits of one source to its text, in the order of their places. Skips an edit that
/// overlaps an earlier one.
std::string apply_edits(std::string_view text, std::span<const Edit> edits);

/// Escapes a text for an XML attribute (in either quotes) or an element. Characters that XML does
/// not allow become U+FFFD.
std::string escape_xml(std::string_view text);

/// Whether a text can replace any name unchanged: a plain or quoted name in YAML, and a name in
/// XML.
bool fits_everywhere(std::string_view text);

/// A text as a YAML scalar that replaces `original`: with the same quotes, or quoted if a plain
/// scalar could be misread.
std::string yaml_like(std::string_view original, std::string_view text);

}  // namespace smurf
