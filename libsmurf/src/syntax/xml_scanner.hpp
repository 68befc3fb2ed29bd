// SPDX-License-Identifier: BSD-3-Clause
// The bytes of an XML file to a tree, and the strictness that tinyxml2 lacks.
#pragma once

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/xml.hpp"

namespace smurf {

struct ScannedXml {
  xml::Document document;   ///< values and texts as written: no entity is decoded
  bool well_formed = true;  ///< false: the structure is broken and was reported
  /// True when tinyxml2 reads the same from the file. Nothing is said of a file that has an `&` or
  /// a carriage return in a value, a CDATA section, a document type or an instruction.
  bool is_plain = true;
};

/// Reports SML1001-SML1013. Stops at the first structural error.
ScannedXml scan_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                    DiagnosticSink& sink);

}  // namespace smurf
