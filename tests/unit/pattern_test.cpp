// SPDX-License-Identifier: BSD-3-Clause
// Regular expressions of users: matches, invalid patterns, and a comparison with std::regex.
#include "schema/pattern.hpp"

#include <optional>
#include <regex>
#include <string>

#include <doctest/doctest.h>

#include "unit/random.hpp"

using namespace smurf;

namespace {

/// None if the pattern is invalid.
std::optional<bool> match(const std::string& pattern, const std::string& text) {
  const auto compiled = Pattern::compile(pattern);
  if (!std::holds_alternative<Pattern>(compiled)) return std::nullopt;
  return std::get<Pattern>(compiled).is_in(text);
}

struct Row {
  std::string pattern, text;
  bool is_match;
};

}  // namespace

TEST_CASE("pattern: what ECMA-262 says") {
  const Row rows[] = {
      {"^a", "ba", false},
      {"a$", "ba", true},
      {"^$", "", true},
      {"^.{3}$", "\u00e4\u00f6\u00fc", true},
      {".", "\n", false},
      {"[]", "a", false},
      {"[^]", "\n", true},
      {"^(a|b)*c$", "ababc", true},
      {"^(a|b)*c$", "abadc", false},
      {"^a{2,3}$", "aaaa", false},
      {"^a{2,}$", "aaaa", true},
      {"^(a?){3}$", "aa", true},
      {"^(?:a|ab)(?:c|bcd)$", "abcd", true},
      {"^(?<name>a)$", "a", true},
      {"^(?!foo)", "foobar", false},
      {"^(?=.*\\d)(?=.*[a-z]).{4,}$", "a1bc", true},
      {"^(?=.*\\d)(?=.*[a-z]).{4,}$", "abcd", false},
      {"(?=b(?=c))", "bc", true},
      {"(?=b(?=c))", "bd", false},
      {"a(?!^)", "a",
       true},  // libstdc++ treats the start of a look-ahead as the beginning of the text
      {"(?<=a)b", "ab", true},
      {"(?<!a)b", "ab", false},
      {"\\bfoo\\b", "a foo b", true},
      {"\\bfoo\\b", "afoo", false},
      {"\\Boo", "foo", true},
      {"^[\\w-]+$", "a-b_c", true},
      {"^[\\D]+$", "a1c", false},
      {"^\\S+$", "a\u00a0b", false},
      {"^\\u00e4\\x41\\cA\\/\\-$", "\u00e4A\x01/-", true},
      {"^\\uD83D\\uDE00$", "\U0001F600", true},
      {"^\\u{1F600}$", "\U0001F600", true},
      {"a{b}]", "a{b}]", true},
  };
  for (const Row& row : rows) {
    CAPTURE(row.pattern);
    CAPTURE(row.text);
    CHECK(match(row.pattern, row.text) == row.is_match);
  }
}

TEST_CASE("pattern: what is none, and what comes to too much") {
  for (const std::string pattern :
       {"(", ")", "[a", "a**", "+", "{1}", "a{3,2}", "[b-a]", "\\", "\\1", "\\k<a>", "\\p{L}",
        "\\y", "[[:alpha:]]", "\\u{110000}", "(a{300}){300}", "((((){1000}){1000}){1000})"}) {
    CAPTURE(pattern);
    CHECK(!match(pattern, "a"));
  }
}

TEST_CASE("pattern: std::regex agrees") {
  MESSAGE("seed " << test::seed());
  test::Random random;
  const char* const kPieces[] = {"a",     "b",   "(",    "(?:",  ")", "|", "*", "+",   "?",
                                 "{1,2}", "{2}", "[ab]", "[^a]", ".", "^", "$", "\\b", "\\w"};
  for (int round = 0; round < 3000; ++round) {
    std::string pattern;
    for (std::size_t count = 1 + random.below(8); count > 0; --count) {
      pattern += kPieces[random.below(std::size(kPieces))];
    }
    std::optional<std::regex> other;
    try {
      other.emplace(pattern);
    } catch (const std::regex_error&) {
      continue;
    }
    for (const std::string text : {"", "a", "ab", "ba b", "abba", "bab"}) {
      CAPTURE(pattern);
      CAPTURE(text);
      const auto own = match(pattern, text);
      if (own) CHECK(*own == std::regex_search(text, *other));
    }
  }
}
