// SPDX-License-Identifier: BSD-3-Clause
// Follows all paths through the pattern at once, character by character (Thompson's simulation), so
// no path is tried twice.
#include "schema/pattern.hpp"

#include <algorithm>

#include "base/deadline.hpp"
#include "base/text/utf8.hpp"

namespace smurf {
namespace {

bool is_word(char32_t c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

std::vector<char32_t> decode(std::string_view text) {
  std::vector<char32_t> characters;
  characters.reserve(text.size());
  while (!text.empty()) {
    const utf8::CodePoint next = utf8::decode(text);
    characters.push_back(next.value);
    text.remove_prefix(next.size);
  }
  return characters;
}

/// One run of a code over a text.
class Run {
 public:
  Run(const Pattern::Code& code, const std::vector<Pattern::Set>& sets,
      const std::vector<char32_t>& text, const std::vector<std::vector<bool>>& looks)
      : code_(code), sets_(sets), text_(text), looks_(looks), seen_at_(code.size(), 0) {}

  /// Whether there is a match that begins anywhere.
  bool find() {
    for (std::size_t at = 0; at <= text_.size(); ++at) {
      if (arrive(at)) return true;
      if (at < text_.size()) take(text_[at]);
    }
    return false;
  }

  /// Where matches end.
  std::vector<bool> ends() {
    std::vector<bool> places(text_.size() + 1);
    for (std::size_t at = 0; at <= text_.size(); ++at) {
      places[at] = arrive(at);
      if (at < text_.size()) take(text_[at]);
    }
    return places;
  }

  /// The places where matches begin; the code is that of the reversed pattern.
  std::vector<bool> begins() {
    std::vector<bool> places(text_.size() + 1);
    for (std::size_t at = text_.size() + 1; at-- > 0;) {
      places[at] = arrive(at);
      if (at > 0) take(text_[at - 1]);
    }
    return places;
  }

 private:
  /// Follows instructions that consume no character, from the states after the last character and
  /// from the beginning of the code. True if it reaches a match.
  bool arrive(std::size_t at) {
    ++arrival_;
    waiting_.clear();
    is_match_ = false;
    follow(0, at);
    for (const std::uint32_t next : arrived_) follow(next, at);
    Deadline::look(1 + arrived_.size() / 4);
    arrived_.clear();
    return is_match_;
  }

  void follow(std::uint32_t first, std::size_t at) {
    open_.push_back(first);
    while (!open_.empty()) {
      const std::uint32_t index = open_.back();
      open_.pop_back();
      if (seen_at_[index] == arrival_) continue;
      seen_at_[index] = arrival_;
      const Pattern::Instruction& one = code_[index];
      switch (one.op) {
      case Pattern::Op::match: is_match_ = true; break;
      case Pattern::Op::character: waiting_.push_back(index); break;
      case Pattern::Op::split: open_.push_back(one.b); [[fallthrough]];
      case Pattern::Op::jump: open_.push_back(one.a); break;
      default:
        if (holds(one, at)) open_.push_back(index + 1);
      }
    }
  }

  bool holds(const Pattern::Instruction& one, std::size_t at) const {
    switch (one.op) {
    case Pattern::Op::begin: return at == 0;
    case Pattern::Op::end: return at == text_.size();
    case Pattern::Op::look: return looks_[one.a][at] != one.is_negated;
    default: break;
    }
    const bool before = at > 0 && is_word(text_[at - 1]);
    const bool after = at < text_.size() && is_word(text_[at]);
    return (before != after) != one.is_negated;
  }

  void take(char32_t c) {
    for (const std::uint32_t index : waiting_) {
      if (sets_[code_[index].a].contains(c)) arrived_.push_back(index + 1);
    }
  }

  const Pattern::Code& code_;
  const std::vector<Pattern::Set>& sets_;
  const std::vector<char32_t>& text_;
  const std::vector<std::vector<bool>>& looks_;  ///< the places where each condition is true
  std::vector<std::size_t> seen_at_;    ///< by instruction: the last position that reached it
  std::vector<std::uint32_t> waiting_;  ///< for a character
  std::vector<std::uint32_t> arrived_;  ///< states after the last character
  std::vector<std::uint32_t> open_;     ///< of follow(); a member to reuse its memory
  std::size_t arrival_ = 0;
  bool is_match_ = false;
};

}  // namespace

bool Pattern::Set::contains(char32_t c) const {
  if (c < ascii.size()) return ascii[c] != is_negated;
  const bool is_listed = std::any_of(ranges.begin(), ranges.end(), [&](const auto& range) {
    return range.first <= c && c <= range.second;
  });
  return is_listed != is_negated;
}

bool Pattern::is_in(std::string_view text) const {
  const std::vector<char32_t> characters = decode(text);
  std::vector<std::vector<bool>> looks;
  for (const Look& look : looks_) {
    Run run(look.code, sets_, characters, looks);
    looks.push_back(look.is_ahead ? run.begins() : run.ends());
  }
  return Run(code_, sets_, characters, looks).find();
}

std::size_t Pattern::steps_for(std::string_view text) const {
  std::size_t size = code_.size();
  for (const Look& look : looks_) size += look.code.size();
  std::size_t ranges = 1;  // in a text that is not ASCII, all ranges of a set may be searched
  for (const Set& set : sets_) ranges = std::max(ranges, set.ranges.size());
  const bool is_ascii = utf8::ascii_prefix(text) == text.size();
  return (text.size() + 1) * size * (is_ascii ? 1 : ranges);
}

}  // namespace smurf
