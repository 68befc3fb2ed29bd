// SPDX-License-Identifier: BSD-3-Clause
// The bytes of an XML file to a tree, and the strictness that tinyxml2 lacks.
#pragma once

#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Reports SML1001-SML1013. None when the structure is broken; stops at the first error of it.
std::optional<xml::Document> scan_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                                      DiagnosticSink& sink);

}  // namespace smurf
