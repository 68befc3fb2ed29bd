// SPDX-License-Identifier: BSD-3-Clause
// The cursor within brackets and braces of YAML, which may span lines: "{joint: [a, ".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::lsp {

/// An open bracket or brace.
struct FlowLevel {
  bool is_mapping = false;
  std::string key;  ///< of a mapping: before the value at the cursor; empty: at a key
  std::vector<std::string> siblings;  ///< the keys before
};

/// The brackets that are open at the cursor, the outermost first, and the word at the cursor.
struct FlowContext {
  std::vector<FlowLevel> levels;
  std::size_t begin = 0;  ///< of the word, behind its quote
  char quote = '\0';
  bool is_comment = false;
};

struct FlowRead {
  std::optional<FlowContext> context;  ///< present when a bracket is open at the end
  std::size_t end = 0;                 ///< else: behind the last bracket
};

/// Reads from the first bracket or brace of a collection to the end of the text. `column` is that
/// of the key or dash before it: a line that begins there or before it belongs to the collection
/// only when it closes it, so a bracket that is not closed yet does not hide the rest of a file.
FlowRead read_flow(std::string_view text, std::size_t begin, std::optional<std::size_t> column);

}  // namespace smurf::lsp
