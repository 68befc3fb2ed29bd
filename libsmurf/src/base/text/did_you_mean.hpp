// SPDX-License-Identifier: BSD-3-Clause
// The end of a message about an unknown name.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/text/suggest.hpp"

namespace smurf {

/// "; did you mean 'x'?" for the nearest of `known`, else for those that begin with `name`; or "".
inline std::string did_you_mean(std::string_view name, std::span<const std::string_view> known) {
  if (const auto found = only_nearest(name, known)) {
    return "; did you mean '" + std::string(*found) + "'?";
  }
  constexpr std::size_t kShortest = 3;  // leading dashes are ignored
  constexpr std::size_t kMost = 3;
  const std::size_t dashes = std::min(name.find_first_not_of('-'), name.size());
  if (name.size() - dashes < kShortest) return {};
  std::string longer;
  std::size_t count = 0;
  for (const std::string_view word : known) {
    if (!word.starts_with(name) || ++count > kMost) continue;
    longer.append(longer.empty() ? "'" : " or '").append(word).append("'");
  }
  return count == 0 || count > kMost ? std::string() : "; did you mean " + longer + "?";
}

}  // namespace smurf
