// SPDX-License-Identifier: BSD-3-Clause
// Percent escapes of URIs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf {

/// Decodes `%20` and other percent escapes. What is no escape stays.
inline std::string decoded_uri(std::string_view uri) {
  const auto digit_of = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_code = uri[i] == '%' && i + 2 < uri.size() && digit_of(uri[i + 1]) >= 0 &&
                         digit_of(uri[i + 2]) >= 0;
    text += is_code ? static_cast<char>(16 * digit_of(uri[i + 1]) + digit_of(uri[i + 2])) : uri[i];
    if (is_code) i += 2;
  }
  return text;
}

/// Writes everything but letters, digits and the characters of `plain` as percent escapes.
inline std::string encoded_uri(std::string_view text, std::string_view plain) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri;
  for (const char c : text) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (is_letter || (c >= '0' && c <= '9') || plain.find(c) != std::string_view::npos) {
      uri += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    uri += '%';
    uri += kDigits[byte >> 4U];
    uri += kDigits[byte & 0xFU];
  }
  return uri;
}

}  // namespace smurf
