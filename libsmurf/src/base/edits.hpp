// SPDX-License-Identifier: BSD-3-Clause
// Byte-range edits of a text: what is not edited stays identical.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Applies edits of one source to its text. Edits are applied in the order of their places; one
/// that overlaps an earlier one is left out.
std::string apply_edits(std::string_view text, std::span<const Edit> edits);

/// Text as it is written inside an XML attribute of either quote, or in an element. What XML cannot
/// hold at all becomes U+FFFD.
std::string escape_xml(std::string_view text);

/// Whether a text may take the place of any name as it is: of a plain or quoted one in YAML, and in
/// XML.
bool fits_everywhere(std::string_view text);

/// Text as a YAML scalar that takes the place of `original`: quoted as that was, or where a plain
/// scalar could be misread.
std::string yaml_like(std::string_view original, std::string_view text);

}  // namespace smurf
