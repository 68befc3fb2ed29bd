// SPDX-License-Identifier: BSD-3-Clause
// Source -> xml::Document.
#pragma once

#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Reports SML00xx and SML100x; none if the structure of the file is broken.
std::optional<xml::Document> parse_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                                       DiagnosticSink& sink);

}  // namespace smurf
