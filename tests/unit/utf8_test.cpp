// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/utf8.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace smurf;

TEST_CASE("utf8: validity") {
  struct Row {
    std::string text;
    int invalid;  // -1: none
  };
  const Row rows[] = {{"", -1},
                      {"abc", -1},
                      {"\xC3\xA4\xE2\x82\xAC\xF0\x9F\xA4\x96", -1},
                      {"\x7F", -1},
                      {"\xC2\x80\xDF\xBF\xE0\xA0\x80\xED\x9F\xBF\xEE\x80\x80\xEF\xBF\xBF", -1},
                      {"\xF0\x90\x80\x80\xF4\x8F\xBF\xBF", -1},
                      {"a\x80", 1},     // continuation alone
                      {"ab\xC3", 2},    // cut short
                      {"\xC3(", 0},     // wrong second byte
                      {"\xC0\x80", 0},  // overlong
                      {"\xC1\xBF", 0},
                      {"\xE0\x9F\xBF", 0},
                      {"\xF0\x8F\xBF\xBF", 0},
                      {"\xED\xA0\x80", 0},      // surrogate
                      {"\xF4\x90\x80\x80", 0},  // beyond U+10FFFF
                      {"\xF5\x80\x80\x80", 0},
                      {"\xFF", 0},
                      {"\xE2\x82", 0},
                      {"\xC3\xA4\xE2\x82", 2}};
  for (const Row& row : rows) {
    CAPTURE(row.text);
    const auto invalid = utf8::find_invalid(row.text);
    CHECK((invalid ? static_cast<int>(*invalid) : -1) == row.invalid);
  }
}

TEST_CASE("utf8: code points") {
  CHECK(utf8::count_code_points("") == 0);
  CHECK(utf8::count_code_points("a\xC3\xA4\xE2\x82\xAC\xF0\x9F\xA4\x96") == 4);
  CHECK(utf8::decode("A").value == U'A');
  CHECK(utf8::decode("\xC3\xA4x").value == U'\u00E4');
  CHECK(utf8::decode("\xE2\x82\xAC").value == U'\u20AC');
  CHECK(utf8::decode("\xF0\x9F\xA4\x96").value == U'\U0001F916');
  CHECK(utf8::decode("\xF0\x9F\xA4\x96").size == 4);
  CHECK(utf8::decode("\xFF").value == 0xFFFD);
  CHECK(utf8::decode("\xFF").size == 1);
  CHECK(utf8::decode("\xE2\x82").size == 1);
}

TEST_CASE("utf8: every code point is read as it was written") {
  std::size_t different = 0;
  for (char32_t value = 0; value <= 0x10FFFF; ++value) {
    if (value == 0xD800) value = 0xE000;
    std::string text;
    utf8::append(text, value);
    const utf8::CodePoint read = utf8::decode(text);
    different += read.value != value || read.size != text.size() || utf8::find_invalid(text);
  }
  CHECK(different == 0);
}

TEST_CASE("utf8: what may be suggested as it is") {
  for (const char* name : {"", "a b.urdf",
                           "m\xC3\xB6"
                           "del.urdf",
                           "\xE6\x97\xA5.yml", "\xEF\xBF\xBD"}) {
    CAPTURE(name);
    CHECK(utf8::is_printable(name));
  }
  for (const char* name : {"mod\xE9l.urdf", "a\nb", "a\x1B[2J", "\x7F", "\xC2\x85",
                           "a\xE2\x80\xAE"
                           "b",
                           "a\xE2\x80\xA8", "\xEF\xBB\xBFx", "\xEF\xBF\xBE"}) {
    CAPTURE(name);
    CHECK_FALSE(utf8::is_printable(name));
  }
}

TEST_CASE("utf8: columns of a terminal") {
  CHECK(utf8::display_width(U'a') == 1);
  CHECK(utf8::display_width(U'\u00E4') == 1);
  CHECK(utf8::display_width(U'\u0301') == 0);
  CHECK(utf8::display_width(U'\u65E5') == 2);
  CHECK(utf8::display_width(U'\uFF21') == 2);
  CHECK(utf8::display_width(U'\U0001F916') == 2);
  CHECK(utf8::display_width(U'\u200D') == 0);
  CHECK(utf8::display_width(U'\u20AC') == 1);
}
