// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/quoted.hpp"

#include "base/text/utf8.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostQuoted = 240;  // bytes; about one line

}  // namespace

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t head = most / 2;
  std::size_t tail = text.size() - most / 4;
  while (head > 0 && utf8::is_continuation(text[head])) --head;
  while (tail < text.size() && utf8::is_continuation(text[tail])) ++tail;
  std::string result(text.substr(0, head));
  result.append("…").append(text.substr(tail));
  return result;
}

std::string quoted(std::string_view text) { return "`" + shortened(text, kMostQuoted) + "`"; }

}  // namespace smurf
