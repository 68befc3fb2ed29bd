// SPDX-License-Identifier: BSD-3-Clause
// Checks on the bytes of a text file before any parser sees them.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Bytes of a UTF-8 byte order mark at the start: 3 or 0.
std::uint32_t byte_order_mark_size(std::string_view text);

/// The language of a text: XML allows U+007F, YAML does not.
enum class TextFormat : std::uint8_t { yaml, xml };

/// Without the NULs at the end, and the blanks among them: readers of XML end there.
std::string_view without_padding(std::string_view text);

/// Reports SML0003-SML0005. False when the text cannot be parsed at all.
bool check_text(const SourceMap& sources, SourceId id, TextFormat format, DiagnosticSink& sink);

}  // namespace smurf
