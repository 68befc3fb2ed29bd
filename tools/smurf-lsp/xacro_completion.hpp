// SPDX-License-Identifier: BSD-3-Clause
// What may be written at the cursor in a xacro.
#pragma once

#include <string>
#include <vector>

#include "smurf-lsp/xacro.hpp"
#include "smurf-lsp/xml_context.hpp"

namespace smurf::lsp {

struct XacroItem {
  enum class Kind { element, attribute, name, function };
  Kind kind{};
  std::string label;
  std::string text;
  std::string snippet;  ///< "": none
  std::string detail;
};

struct XacroItems {
  std::size_t begin = 0;   ///< of the word before the cursor
  bool are_all = false;    ///< nothing else may be written there
  bool are_files = false;  ///< the name of a file is written there
  std::vector<XacroItem> list;
};
XacroItems xacro_items(const XacroFamily& family, std::size_t offset, const XmlContext& context);

}  // namespace smurf::lsp
