// SPDX-License-Identifier: BSD-3-Clause
#include "render/wrap.hpp"

#include <algorithm>

#include "render/printable.hpp"

namespace smurf::render {

std::string wrap(std::string_view text, std::size_t indent, std::size_t columns) {
  const std::string margin(indent, ' ');
  std::string out;
  std::size_t used = 0;  // columns of the current line; 0: it is empty
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    const std::size_t width = width_of(word);
    if (used > 0 && !word.empty() && used + 1 + width > columns) {
      out += '\n';
      used = 0;
    }
    if (!word.empty()) {
      out.append(used == 0 ? margin : " ").append(word);
      used += (used == 0 ? indent : 1) + width;
    }
    if (end < text.size() && text[end] == '\n') {
      out += '\n';
      used = 0;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out + "\n";
}

}  // namespace smurf::render
