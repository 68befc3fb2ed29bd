// SPDX-License-Identifier: BSD-3-Clause
// Where the cursor is in an XML file that is being written, and so need not be XML yet.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::lsp {

struct XmlContext {
  enum class Kind { content, element, end_tag, attribute, value, other };
  Kind kind = Kind::other;
  std::vector<std::string_view> open = {};        ///< elements around it, the outermost first
  std::string_view element = {};                  ///< whose tag it is in
  std::string_view attribute = {};                ///< whose value it is in
  std::vector<std::string_view> attributes = {};  ///< those that the tag has before it
  std::size_t tag = 0;                            ///< the '<' of the tag
  std::size_t begin = 0;                          ///< of the word that is written, up to the cursor
};

XmlContext xml_context(std::string_view text, std::size_t offset);

/// The text without the tag that is being written at the cursor.
std::string without_tag(std::string_view text, std::size_t tag, std::size_t offset);

}  // namespace smurf::lsp
