// SPDX-License-Identifier: BSD-3-Clause
// What an XML file says of itself before its first element.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Reports an XML declaration that is not the first thing in the file (SML1005), or that names
/// another encoding than that of the bytes, which are UTF-8 (SML1008).
void check_xml_prolog(std::string_view text, SourceId id, DiagnosticSink& sink);

}  // namespace smurf
