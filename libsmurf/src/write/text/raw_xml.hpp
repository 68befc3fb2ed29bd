// SPDX-License-Identifier: BSD-3-Clause
// Elements of a URDF that are copied to another document.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Adds the edits that move a namespace declaration of the robot element into those of its
/// children that use the prefix.
void declare_prefix(xml::View robot, const xml::Attribute& declaration, std::vector<Edit>& edits);

/// The text of an element after the edits, as strict XML with a declaration of every namespace
/// prefix that it uses. `source` is the text of the whole document.
std::string raw_xml(xml::View element, std::string_view source, std::vector<Edit> edits = {});

}  // namespace smurf
