// SPDX-License-Identifier: BSD-3-Clause
// Reads a scanned file again with tinyxml2, the parser of sdformat, MuJoCo and Bullet. This is the
// only place that uses tinyxml2. Tests compare its results with ours, and smurf2urdf checks its
// output with it.
#pragma once

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Replaces our values and texts by those that tinyxml2 reads, except for those with a wrong
/// reference, which it garbles. False if it refuses the file or sees other elements (SML1001). In
/// the library smurf::referees.
bool read_by_tinyxml2(xml::Document& document, const SourceMap& sources, DiagnosticSink& sink);

}  // namespace smurf
