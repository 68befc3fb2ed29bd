// SPDX-License-Identifier: BSD-3-Clause
// What tinyxml2, by which sdformat, MuJoCo and Bullet read, makes of a file that our scanner has
// read. The only place that knows it. The tests hold both equal; a build with SMURF_SCANNERS=OFF
// asks it for every file.
#pragma once

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Puts the values and texts that tinyxml2 reads in the place of ours, but for those with a wrong
/// reference, which it garbles. False when it refuses the file or sees other elements (SML1001).
bool read_by_tinyxml2(xml::Document& document, const SourceMap& sources, DiagnosticSink& sink);

}  // namespace smurf
