// SPDX-License-Identifier: BSD-3-Clause
// Repairs what readers of URDF accept, but readers of strict XML (expat, libxml2, browsers) refuse.
// The repaired text means the same to both.
#pragma once

#include <string>
#include <string_view>

#include "smurf/xml.hpp"

namespace smurf {

/// `text` is part of a file that our reader accepted. URDF readers read an undefined `&name;`
/// literally, so its `&` is escaped; `--` in a comment, `]]>` in a text and characters that XML
/// does not allow are replaced.
std::string strict_xml(std::string_view text);

/// The same for a whole file that our reader accepted; also repairs its XML declaration and blanks
/// that are missing between attributes.
std::string strict_xml_file(const std::string& text);

/// Why readers of strict XML refuse a file that strict_xml_file() made; empty if they accept it.
/// There is no repair: another name would mean something else.
std::string why_strict_readers_refuse(const xml::Document& document, std::string_view text);

}  // namespace smurf
