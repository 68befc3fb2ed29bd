// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/floating.hpp"

#ifdef __cpp_lib_to_chars

#include <array>

namespace smurf {
namespace {

using Buffer = std::array<char, 512>;  // the longest double without exponent has 327 characters

template <class... Arguments>
std::string written(Arguments... arguments) {
  Buffer buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), arguments...).ptr;
  return {buffer.data(), end};
}

}  // namespace

std::from_chars_result read_floating(std::string_view text, double& value) {
  return std::from_chars(text.data(), text.data() + text.size(), value);
}

std::from_chars_result read_hexadecimal(std::string_view text, double& value) {
  return std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::hex);
}

std::string shortest(double value, Notation notation) {
  if (notation == Notation::shorter) return written(value);
  const bool is_fixed = notation == Notation::fixed;
  return written(value, is_fixed ? std::chars_format::fixed : std::chars_format::scientific);
}

std::string shortest(float value) { return written(value); }

std::string general(double value, int digits) {
  return written(value, std::chars_format::general, digits);
}

}  // namespace smurf

#else

namespace smurf {

std::from_chars_result read_floating(std::string_view text, double& value) {
  return portable::read_floating(text, value);
}

std::from_chars_result read_hexadecimal(std::string_view text, double& value) {
  return portable::read_hexadecimal(text, value);
}

std::string shortest(double value, Notation notation) {
  return portable::shortest(value, notation);
}

std::string shortest(float value) { return portable::shortest(value); }

std::string general(double value, int digits) { return portable::general(value, digits); }

}  // namespace smurf

#endif
