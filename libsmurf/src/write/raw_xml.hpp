// SPDX-License-Identifier: BSD-3-Clause
// Elements of a URDF that stand in another document as they are written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// The same for readers that forgive less than those of URDF: where these take `&name;` that
/// nothing defines for its letters, the letters are written, and `]]>` in a text and characters
/// that XML does not have are replaced. `text` is part of what our reader accepted.
std::string strict_xml(std::string_view text);

/// The edits by which the children of a robot that use the prefix of one of its declarations
/// declare it themselves.
void declare_prefix(xml::View robot, const xml::Attribute& declaration, std::vector<Edit>& edits);

/// Its text as strict XML, with the edits, and with the prefixes that it uses declared. `source` is
/// the text of its document.
std::string raw_xml(xml::View element, std::string_view source, std::vector<Edit> edits = {});

}  // namespace smurf
