// SPDX-License-Identifier: BSD-3-Clause
// Rewords yaml-cpp's errors for people who edit a file.
#pragma once

#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Reports SML0010. `words` and `place` are yaml-cpp's message and position, which does not count
/// the byte order mark; `bracket` is the innermost open bracket there, or empty.
void report_parser_error(std::string_view words, int place, Span bracket, const SourceMap& sources,
                         DiagnosticSink& sink);

}  // namespace smurf
