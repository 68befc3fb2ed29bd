// SPDX-License-Identifier: BSD-3-Clause
// Everything that is read of an XML text, as a text to compare.
#pragma once

#include <string>

#include "syntax/xml_reader.hpp"

namespace smurf::test {

/// A line a diagnostic, then a line an element with all its members.
std::string described_xml(XmlEngine engine, const std::string& text);

}  // namespace smurf::test
