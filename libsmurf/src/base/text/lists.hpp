// SPDX-License-Identifier: BSD-3-Clause
// Lists in sentences.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"

namespace smurf {

/// Each name in backticks.
template <class Names>
std::vector<std::string> all_quoted(const Names& names) {
  std::vector<std::string> all;
  for (const std::string_view name : names) all.push_back(quoted(name));
  return all;
}

/// Joined by commas: "a, b, c".
template <class Words>
std::string listed(const Words& words) {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "" : ", ").append(word);
  return text;
}

/// "a, b and c"; `last` is between the last two.
template <class Words>
std::string enumerated(const Words& words, std::string_view last = " and ") {
  std::string text;
  std::size_t left = words.size();
  for (const std::string_view word : words) {
    text.append(left == words.size() ? "" : left == 1 ? last : ", ").append(word);
    --left;
  }
  return text;
}

/// "a, b and 3 more": the first `most`; the others are counted by a noun.
template <class Words>
std::string shortlist(const Words& words, std::size_t most, std::string_view one = "more",
                      std::string_view several = "more") {
  std::string text;
  std::size_t shown = 0;
  for (const std::string_view word : words) {
    if (shown == most) return text + " and " + counted(words.size() - shown, one, several);
    text.append(shown == 0 ? "" : ", ").append(word);
    ++shown;
  }
  return text;
}

/// "a, b and c"; of more than `most`, "a, b and 3 more".
template <class Words>
std::string enumerated_to(std::size_t most, const Words& words, std::string_view one = "more",
                          std::string_view several = "more") {
  return words.size() <= most ? enumerated(words) : shortlist(words, most, one, several);
}

/// The names that a user may choose from: "`base`, `arm` or `hand`", and of more than eight
/// "`a`, `b`, ... or one of 12 more".
inline std::string choices(std::span<const std::string_view> names) {
  constexpr std::size_t kMost = 8;
  if (names.size() <= kMost) return enumerated(all_quoted(names), " or ");
  return listed(all_quoted(names.first(kMost - 1))) + " or one of " +
         std::to_string(names.size() - kMost + 1) + " more";
}

}  // namespace smurf
