// SPDX-License-Identifier: BSD-3-Clause
// The declarations of an XML file before its first element.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Reports an XML declaration that is not the first thing in the file (SML1005), or that names
/// another encoding than UTF-8, the actual one (SML1008).
void check_xml_prolog(std::string_view text, SourceId id, DiagnosticSink& sink);

/// The name of the encoding that the XML declaration of a text names; empty if it names none, or
/// UTF-8, or a part of it.
Span other_encoding(std::string_view text, SourceId id);

/// The place of anything other than attributes in an XML declaration (`<?xml ...?>`, recognised as
/// in TinyXML); none for a sound declaration and for other instructions.
std::optional<std::size_t> find_unsound(std::string_view instruction);

/// Reports, at `place`, a declaration in which all that is wrong is that values have no quotes:
/// `<?xml version=1.0?>`. False for others. TinyXML and tinyxml2 read on behind it.
bool report_unquoted(std::string_view declaration, Span place, DiagnosticSink& sink);

/// Reports a version in an XML declaration that browsers and lxml refuse (SML1018).
void check_xml_version(Span declaration, std::string_view text, DiagnosticSink& sink);

/// The end of the document type that begins at `start`, which is `<!DOCTYPE`. Reports
/// declarations within it: TinyXML and tinyxml2 end it at the first '>'. None, with a report, if it
/// is never closed, or contains more than declarations: an element for tinyxml2, or a comment that
/// may contain the robot.
std::optional<std::uint32_t> read_doctype(std::string_view text, Span start, DiagnosticSink& sink);

}  // namespace smurf
