// SPDX-License-Identifier: BSD-3-Clause
// What tinyxml2, by which sdformat, MuJoCo and Bullet read, makes of a file that our scanner has
// read. The only place that knows it. The tests hold both equal, and smurf2urdf asks it about what
// it writes.
#pragma once

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Puts the values and texts that tinyxml2 reads in the place of ours, but for those with a wrong
/// reference, which it garbles. False when it refuses the file or sees other elements (SML1001). In
/// the library smurf::referees.
bool read_by_tinyxml2(xml::Document& document, const SourceMap& sources, DiagnosticSink& sink);

}  // namespace smurf
