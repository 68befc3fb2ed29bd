// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/embedded_page.hpp"

namespace smurf {

std::string page_around(const EmbeddedPage& page, std::string_view json) {
  std::string text;
  text.reserve(json.size() + json.size() / 8);
  for (const std::string_view piece : page.head) text += piece;
  while (!json.empty()) {
    const std::size_t end = json.find('<');
    text += json.substr(0, end);
    if (end == std::string_view::npos) break;
    text += "\\u003c";
    json.remove_prefix(end + 1);
  }
  for (const std::string_view piece : page.tail) text += piece;
  return text;
}

}  // namespace smurf
