// SPDX-License-Identifier: BSD-3-Clause
// Finds out where the cursor is in a YAML file that is being written and may be malformed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "config/key_help.hpp"

namespace smurf::lsp {

struct YamlContext {
  KeyPath path;             ///< of the mapping or list around the cursor
  std::string key;          ///< key of the value at the cursor; "": a key, or an item of a list
  std::size_t begin = 0;    ///< of the word at the cursor
  std::size_t end = 0;      ///< of that word
  std::size_t column = 0;   ///< of the keys around the cursor, in bytes
  char quote = '\0';        ///< open quote before the word
  bool is_flow = false;     ///< within braces or brackets
  bool is_comment = false;  ///< the cursor is in a comment; all else is empty
  std::vector<std::string> siblings = {};  ///< the other keys of the mapping
};

YamlContext yaml_context(std::string_view text, std::size_t offset);

}  // namespace smurf::lsp
