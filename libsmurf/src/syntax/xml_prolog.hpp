// SPDX-License-Identifier: BSD-3-Clause
// What an XML file declares before its first element.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Reports an XML declaration that is not the first thing in the file (SML1005), or that names
/// another encoding than that of the bytes, which are UTF-8 (SML1008).
void check_xml_prolog(std::string_view text, SourceId id, DiagnosticSink& sink);

/// Where an XML declaration (`<?xml ...?>`, as TinyXML tells it) holds something else than
/// attributes; none for a sound one and for every other instruction.
std::optional<std::size_t> find_unsound(std::string_view instruction);

/// Reports declarations within a document type, which TinyXML and tinyxml2 take for closed at the
/// first '>' within. False if more than declarations is there: an element for tinyxml2, or a
/// comment that may hold the robot.
bool check_declarations(Span doctype, std::string_view subset, DiagnosticSink& sink);

}  // namespace smurf
