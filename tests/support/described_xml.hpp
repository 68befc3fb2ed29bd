// SPDX-License-Identifier: BSD-3-Clause
// Everything that is read from an XML text, as a text to compare.
#pragma once

#include <string>

namespace smurf::test {

enum class XmlReader : bool { ours, tinyxml2 };
/// One line per diagnostic, then one line per element with all its members.
std::string described_xml(XmlReader reader, const std::string& text);

}  // namespace smurf::test
