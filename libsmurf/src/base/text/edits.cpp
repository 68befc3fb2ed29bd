// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/edits.hpp"

#include <algorithm>
#include <vector>

#include "base/text/utf8.hpp"

namespace smurf {

std::string apply_edits(std::string_view text, std::span<const Edit> edits) {
  std::vector<const Edit*> sorted;
  for (const Edit& edit : edits) sorted.push_back(&edit);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Edit* a, const Edit* b) { return a->span.begin < b->span.begin; });
  std::string result;
  std::size_t at = 0;
  for (const Edit* edit : sorted) {
    if (edit->span.begin < at) continue;
    result += text.substr(at, edit->span.begin - at);
    result += edit->text;
    at = edit->span.end;
  }
  result += text.substr(at);
  return result;
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    const std::string_view bytes = text.substr(0, point.size);
    text.remove_prefix(point.size);
    const char32_t c = point.value;
    const bool is_space = c == '\t' || c == '\n' || c == '\r';
    switch (c) {
    case '&': escaped += "&amp;"; continue;
    case '<': escaped += "&lt;"; continue;
    case '"': escaped += "&quot;"; continue;
    case '\'': escaped += "&apos;"; continue;
    // "]]>" ends a section of CDATA, and is an error elsewhere.
    case '>': escaped += escaped.ends_with("]]") ? "&gt;" : ">"; continue;
    default: break;
    }
    if ((c < 0x20 && !is_space) || c >= 0xFFFD) {
      escaped += c > 0xFFFF ? bytes : utf8::kReplacement;
    } else if (utf8::is_control(c)) {
      // Readers turn line ends in attributes into spaces, unless they are written like this.
      escaped += "&#" + std::to_string(static_cast<std::uint32_t>(c)) + ";";
    } else {
      escaped += bytes;
    }
  }
  return escaped;
}

namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '/' || c == '.' || c == '=';
}

}  // namespace

bool fits_everywhere(std::string_view text) {
  if (text.empty() || text.front() == '-' || text.front() == ' ' || text.back() == ' ')
    return false;
  return std::all_of(text.begin(), text.end(), [](char c) { return is_plain(c) || c == ' '; });
}

std::string yaml_like(std::string_view original, std::string_view text) {
  const bool has_control = std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  });
  if (original.starts_with('\'') && !has_control) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
    return quoted + "'";
  }
  const bool starts_like_a_word = !text.empty() && is_plain(text.front()) && text.front() != '-';
  if (!original.starts_with('"') && starts_like_a_word &&
      std::all_of(text.begin(), text.end(), is_plain)) {
    return std::string(text);
  }
  std::string quoted = "\"";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      quoted.append("\\x") += kDigits[byte >> 4U];
      quoted += kDigits[byte & 0xFU];
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace smurf
