// SPDX-License-Identifier: BSD-3-Clause
// Regular expressions of users, matched in bounded time: length of the text times size
// of the pattern. std::regex needs quadratic time, and a stack frame for each
// character.
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

/// A regular expression of ECMA-262 with the flag `u`, over Unicode characters, without
/// back-references and `\p{...}`.
class Pattern {
 public:
  /// The result of compile() for an invalid pattern: the reason.
  using Fault = std::string;
  static std::variant<Pattern, Fault> compile(std::string_view text);

  /// Whether it matches anywhere in the text.
  bool is_in(std::string_view text) const;
  /// The largest number of steps of is_in(), of about 20 ns each.
  std::size_t steps_for(std::string_view text) const;

  /// A set of characters.
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
    std::uint32_t a = 0;      ///< character: set; split, jump: next instruction; look: its index
    std::uint32_t b = 0;      ///< split: the other next instruction
  };
  using Code = std::vector<Instruction>;
  /// A condition on the text after or before a position. The code for the text after it runs from
  /// the end of the text to its beginning, so one run finds all positions.
  struct Look {
    Code code;
    bool is_ahead = true;
  };

 private:
  std::vector<Set> sets_;
  std::vector<Look> looks_;  ///< inner ones before outer ones
  Code code_;

  friend class PatternCompiler;
};

}  // namespace smurf
