// SPDX-License-Identifier: BSD-3-Clause
// Where the cursor is in a YAML file that is being written, and so need not be YAML yet.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/key_help.hpp"

namespace smurf::lsp {

struct YamlContext {
  KeyPath path;             ///< of the mapping or list that the cursor is in
  std::string key;          ///< whose value is written; "": a key, or an item of a list
  std::size_t begin = 0;    ///< of the word that is written
  std::size_t end = 0;      ///< behind it
  std::size_t column = 0;   ///< in bytes, of the keys around it
  bool is_flow = false;     ///< within braces
  bool is_comment = false;  ///< it is in a comment, and nothing else is said
  std::vector<std::string> siblings = {};  ///< keys that the mapping has already
};

YamlContext yaml_context(std::string_view text, std::size_t offset);

}  // namespace smurf::lsp
