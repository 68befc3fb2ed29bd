// SPDX-License-Identifier: BSD-3-Clause
// Parses the bytes of an XML file into a tree, more strictly than tinyxml2.
#pragma once

#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Reports SML1001-SML1013. None if the structure is broken; stops at the first such error.
std::optional<xml::Document> scan_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                                      DiagnosticSink& sink);

}  // namespace smurf
