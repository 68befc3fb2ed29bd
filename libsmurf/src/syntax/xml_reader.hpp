// SPDX-License-Identifier: BSD-3-Clause
// Source -> xml::Document. The only place that knows tinyxml2.
#pragma once

#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Reports SML00xx and SML100x; none when the structure of the file is broken.
std::optional<xml::Document> parse_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                                       DiagnosticSink& sink);

/// tinyxml2 decides what a value is. The scanner of xml_scanner.hpp reads the same of plain files,
/// only faster; parse_xml() believes it there unless the build says SMURF_SCANNERS=OFF.
enum class XmlEngine : bool { scanner_first, tinyxml2 };
std::optional<xml::Document> parse_xml_by(XmlEngine engine, const SourceMap& sources, SourceId id,
                                          const Limits& limits, DiagnosticSink& sink);

}  // namespace smurf
