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

std::string choices(std::span<const std::string_view> names) {
  constexpr std::size_t kMost = 8;
  const std::size_t shown = names.size() > kMost ? kMost - 1 : names.size();
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == names.size();
    text += (i == 0 ? "" : is_last ? " or " : ", ") + quoted(names[i]);
  }
  if (shown < names.size()) text += " or one of " + std::to_string(names.size() - shown) + " more";
  return text;
}

}  // namespace smurf
