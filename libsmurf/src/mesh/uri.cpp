// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/uri.hpp"

namespace smurf {
namespace {

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::string decoded_uri(std::string_view uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_code = uri[i] == '%' && i + 2 < uri.size() && digit_of(uri[i + 1]) >= 0 &&
                         digit_of(uri[i + 2]) >= 0;
    name += is_code ? static_cast<char>(16 * digit_of(uri[i + 1]) + digit_of(uri[i + 2])) : uri[i];
    if (is_code) i += 2;
  }
  return name;
}

}  // namespace smurf
