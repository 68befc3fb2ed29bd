// SPDX-License-Identifier: BSD-3-Clause
// References (`&...;`) in an XML file, and the decoded values that contain them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf {

struct XmlReference {
  enum class Kind { character, unknown_entity, none };

  Kind kind = Kind::none;
  std::size_t size = 1;  ///< bytes from '&' to ';'; without a reference, only the '&'
  char32_t character = 0;
};

/// Reads the reference at the beginning of `text`, which may extend beyond the value. A reference
/// to a character that XML does not allow, such as `&#0;`, has Kind::none.
XmlReference read_reference(std::string_view text);

/// `&#` without a number and a semicolon, which TinyXML refuses.
bool is_broken_character(std::string_view text);

/// Whether readers misread the reference: tinyxml2 9 copies an unknown entity from a wrong place,
/// and truncates a value at `&#0;`.
bool has_wrong_reference(std::string_view written);

/// Decodes a value or text: replaces character references, and every line end with '\n'. Leaves
/// anything else that begins with '&' unchanged.
std::string decode_xml(std::string_view written);
/// Decodes a CDATA section like decode_xml(), but without references.
std::string decode_character_section(std::string_view written);

}  // namespace smurf
