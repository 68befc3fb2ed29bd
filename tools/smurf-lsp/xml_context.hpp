// SPDX-License-Identifier: BSD-3-Clause
// Finds out where the cursor is in an XML file that is being written and may be malformed.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::lsp {

struct XmlContext {
  enum class Kind { content, element, end_tag, attribute, value, other };
  Kind kind = Kind::other;
  std::vector<std::string_view> open = {};  ///< elements around the cursor, the outermost first
  std::string_view element = {};            ///< the element whose tag contains the cursor
  std::string_view attribute = {};          ///< the attribute whose value contains the cursor
  std::vector<std::string_view> attributes = {};  ///< the attributes before the cursor in the tag
  std::size_t tag = 0;                            ///< position of the '<' of the tag
  std::size_t begin = 0;                          ///< of the word before the cursor
};

XmlContext xml_context(std::string_view text, std::size_t offset);

/// The text without the tag that is being written at the cursor. In its place, the elements in
/// `unclosed` end, the innermost last in the list.
std::string without_tag(std::string_view text, std::size_t tag, std::size_t offset,
                        std::span<const std::string_view> unclosed = {});

}  // namespace smurf::lsp
