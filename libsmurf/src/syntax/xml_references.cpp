// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/xml_references.hpp"

#include <charconv>
#include <cstdint>
#include <utility>

#include "base/text/utf8.hpp"

namespace smurf {
namespace {

constexpr std::pair<std::string_view, char> kEntities[] = {
    {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};

constexpr bool is_character(std::uint32_t value) {
  if (value < 0x20) return value == '\t' || value == '\n' || value == '\r';
  return value < 0xD800 || (value > 0xDFFF && value < 0xFFFE) ||
         (value > 0xFFFF && value <= 0x10FFFF);
}

/// The character for "x1F600" or "65"; 0 if XML does not allow it.
char32_t character_of(std::string_view digits) {
  const int base = digits.starts_with('x') ? 16 : 10;
  if (base == 16) digits.remove_prefix(1);
  std::uint32_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value, base);
  const bool is_number = result.ec == std::errc() && result.ptr == end;
  return is_number && is_character(value) ? value : 0;
}

std::string decode(std::string_view written, bool has_references) {
  std::string decoded;
  decoded.reserve(written.size());
  for (std::size_t at = 0; at < written.size();) {
    const char c = written[at];
    if (c == '\r' || c == '\n') {
      const char other = c == '\r' ? '\n' : '\r';  // tinyxml2 joins "\n\r" as well
      at += at + 1 < written.size() && written[at + 1] == other ? 2 : 1;
      decoded += '\n';
    } else if (const XmlReference reference =
                   c == '&' && has_references ? read_reference(written.substr(at)) : XmlReference();
               reference.kind == XmlReference::Kind::character) {
      utf8::append(decoded, reference.character);
      at += reference.size;
    } else {
      decoded += c;
      ++at;
    }
  }
  return decoded;
}

}  // namespace

XmlReference read_reference(std::string_view text) {
  const std::size_t end = text.find_first_of("; <\"'&", 1);
  const bool is_closed = end != std::string_view::npos && end > 1 && text[end] == ';';
  if (!is_closed) return {};
  const std::string_view name = text.substr(1, end - 1);
  if (name.front() == '#') {
    const char32_t character = character_of(name.substr(1));
    if (character == 0) return {};
    return {XmlReference::Kind::character, end + 1, character};
  }
  for (const auto& [entity, character] : kEntities) {
    if (name == entity) {
      return {XmlReference::Kind::character, end + 1, static_cast<char32_t>(character)};
    }
  }
  return {XmlReference::Kind::unknown_entity, end + 1, 0};
}

bool is_broken_character(std::string_view text) {
  if (!text.starts_with("&#")) return false;
  const bool is_hexadecimal = text.substr(2).starts_with('x');
  const std::string_view digits = is_hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";
  const std::size_t begin = is_hexadecimal ? 3 : 2;
  const std::size_t end = text.find_first_not_of(digits, begin);
  return end == std::string_view::npos || end == begin || text[end] != ';';
}

bool has_wrong_reference(std::string_view written) {
  for (std::size_t at = written.find('&'); at != std::string_view::npos;
       at = written.find('&', at + 1)) {
    if (read_reference(written.substr(at)).kind != XmlReference::Kind::character) return true;
  }
  return false;
}

std::string decode_xml(std::string_view written) { return decode(written, true); }
std::string decode_character_section(std::string_view written) { return decode(written, false); }

}  // namespace smurf
