// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/yaml_spans.hpp"

#include <algorithm>

#include "base/text/words.hpp"

namespace smurf {
namespace {

std::uint32_t size_of(std::string_view text) { return static_cast<std::uint32_t>(text.size()); }

/// One past the closing quote; none if the quote is not closed.
std::optional<std::uint32_t> quoted_end(std::string_view text, std::uint32_t begin) {
  const char quote = text[begin];
  for (std::uint32_t at = begin + 1; at < size_of(text); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text[at] == quote) {
      if (quote == '\'' && at + 1 < size_of(text) && text[at + 1] == '\'') {
        ++at;
      } else {
        return at + 1;
      }
    }
  }
  return std::nullopt;
}

/// The end of the last visible character of `value`. Folding and indentation change spaces and line
/// ends, so source and value agree only in the other characters.
std::uint32_t visible_end(std::string_view text, std::uint32_t begin, std::string_view value) {
  std::uint32_t at = begin;
  for (const char c : value) {
    if (is_blank(c)) continue;
    while (at < size_of(text) && is_blank(text[at])) ++at;
    if (at >= size_of(text) || text[at] != c) break;
    ++at;
  }
  return at;
}

std::uint32_t plain_end(std::string_view text, std::uint32_t begin, std::string_view value) {
  if (text.substr(begin, value.size()) == value) return begin + size_of(value);
  return visible_end(text, begin, value);
}

/// The last line that is not blank; for an empty block scalar, its header.
std::uint32_t block_end(std::string_view text, std::uint32_t begin, std::string_view value) {
  auto end = static_cast<std::uint32_t>(std::min(text.find('\n', begin), text.size()));
  const bool is_blank_only = std::all_of(value.begin(), value.end(), is_blank);
  if (!is_blank_only) {
    end = visible_end(text, end, value);
    end = static_cast<std::uint32_t>(std::min(text.find('\n', end), text.size()));
  }
  if (end > begin && text[end - 1] == '\r') --end;
  return end;
}

}  // namespace

std::uint32_t skip_blank(std::string_view text, std::uint32_t at) {
  while (at < size_of(text)) {
    if (is_blank(text[at])) {
      ++at;
    } else if (text[at] == '#' && (at == 0 || is_blank(text[at - 1]))) {
      at = static_cast<std::uint32_t>(std::min(text.find('\n', at), text.size()));
    } else {
      break;
    }
  }
  return at;
}

std::uint32_t skip_properties(std::string_view text, std::uint32_t at) {
  while (at < size_of(text) && (text[at] == '&' || text[at] == '!')) {
    const bool is_verbatim = text.substr(at).starts_with("!<");
    const std::string_view stops = is_verbatim ? ">" : " \t\r\n,[]{}";
    const std::size_t stop = std::min(text.find_first_of(stops, at), text.size());
    at = skip_blank(text, static_cast<std::uint32_t>(stop) + (is_verbatim && stop < text.size()));
  }
  return at;
}

ScalarExtent scalar_extent(std::string_view text, std::uint32_t at, std::string_view value) {
  ScalarExtent extent;
  extent.begin = skip_properties(text, at);
  if (extent.begin >= size_of(text)) {
    extent.begin = extent.end = size_of(text);
    return extent;
  }
  switch (text[extent.begin]) {
  case '"':
  case '\'': {
    extent.style =
        text[extent.begin] == '"' ? yaml::Style::double_quoted : yaml::Style::single_quoted;
    const std::optional<std::uint32_t> end = quoted_end(text, extent.begin);
    extent.closed = end.has_value();
    extent.end = end.value_or(size_of(text));
    break;
  }
  case '|':
  case '>':
    extent.style = yaml::Style::block;
    extent.end = block_end(text, extent.begin, value);
    break;
  default: extent.end = plain_end(text, extent.begin, value); break;
  }
  return extent;
}

std::uint32_t flow_end(std::string_view text, std::uint32_t at) {
  for (at = skip_blank(text, at); at < size_of(text); at = skip_blank(text, at + 1)) {
    if (text[at] == ']' || text[at] == '}') return at + 1;
    if (text[at] == '&' || text[at] == '!') {  // span of an absent value
      at = skip_properties(text, at) - 1;
    } else if (text[at] != ',' && text[at] != ':' && text[at] != '?') {
      break;
    }
  }
  return at;
}

}  // namespace smurf
