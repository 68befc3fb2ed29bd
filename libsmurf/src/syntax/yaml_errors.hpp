// SPDX-License-Identifier: BSD-3-Clause
// yaml-cpp's errors in the words of somebody who edits a file.
#pragma once

#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Reports SML0010. `words` and `place` are yaml-cpp's message and position, which counts bytes
/// behind the byte order mark; `bracket` is the innermost one that is open there, or empty.
void report_parser_error(std::string_view words, int place, Span bracket, const SourceMap& sources,
                         DiagnosticSink& sink);

}  // namespace smurf
