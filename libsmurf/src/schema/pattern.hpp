// SPDX-License-Identifier: BSD-3-Clause
// Regular expressions of users, matched in a time that is known before: the length of the text
// times the size of the pattern. std::regex takes the square of the text, and a stack frame for
// each of its characters.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace smurf {

/// A regular expression as ECMA-262 has them with the flag `u`, over Unicode characters, without
/// references back and without `\p{...}`.
class Pattern {
 public:
  /// The result of compile() for an invalid pattern: why it is invalid.
  using Fault = std::string;
  static std::variant<Pattern, Fault> compile(std::string_view text);

  /// Whether it matches anywhere in the text.
  bool is_in(std::string_view text) const;
  /// The most steps that is_in() takes, of some 20 ns each.
  std::size_t steps_for(std::string_view text) const;

  /// What a character may be.
  struct Set {
    std::bitset<128> ascii;
    std::vector<std::pair<char32_t, char32_t>> ranges;
    bool is_negated = false;

    bool contains(char32_t c) const;
  };
  enum class Op : std::uint8_t { match, character, split, jump, begin, end, word_edge, look };
  struct Instruction {
    Op op = Op::match;
    bool is_negated = false;  ///< word_edge, look
    std::uint32_t a = 0;      ///< character: set; split, jump: next instruction; look: which
    std::uint32_t b = 0;      ///< split: the other next instruction
  };
  using Code = std::vector<Instruction>;
  /// What has to follow a place, or to precede it. The code of what follows is made to be run from
  /// the end of the text to its begin, so that one run finds all places where it does.
  struct Look {
    Code code;
    bool is_ahead = true;
  };

 private:
  std::vector<Set> sets_;
  std::vector<Look> looks_;  ///< inner ones before those around them
  Code code_;

  friend class PatternCompiler;
};

}  // namespace smurf
