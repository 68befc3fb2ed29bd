// SPDX-License-Identifier: BSD-3-Clause
#include "base/suggest.hpp"

#include <algorithm>
#include <vector>

#include "base/path.hpp"

namespace smurf {

int edit_distance(std::string_view a, std::string_view b, int limit) {
  if (a == b) return 0;
  if (path::to_lower(a) == path::to_lower(b)) return 1;
  const int size_a = static_cast<int>(a.size());
  const int size_b = static_cast<int>(b.size());
  if (std::abs(size_a - size_b) > limit) return limit + 1;

  // Optimal string alignment over three rows.
  const auto width = static_cast<std::size_t>(size_b) + 1;
  std::vector<int> before(width);
  std::vector<int> previous(width);
  std::vector<int> current(width);
  for (std::size_t j = 0; j < width; ++j) previous[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = static_cast<int>(i);
    int best = current[0];
    for (std::size_t j = 1; j < width; ++j) {
      const int replace = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({previous[j] + 1, current[j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], before[j - 2] + 1);
      }
      best = std::min(best, current[j]);
    }
    if (best > limit) return limit + 1;
    std::swap(before, previous);
    std::swap(previous, current);
  }
  return previous[width - 1];
}

std::optional<std::string_view> nearest(std::string_view name,
                                        std::span<const std::string_view> known) {
  // Long names are rarely misspelt beyond recognition; the bound also keeps hostile input cheap.
  constexpr std::size_t kLongestName = 200;
  if (name.empty() || name.size() > kLongestName) return std::nullopt;
  const int limit = std::max(1, static_cast<int>(name.size()) / 3);
  int best = limit + 1;
  std::optional<std::string_view> found;
  for (const std::string_view candidate : known) {
    if (candidate == name) return std::nullopt;
    const int distance = edit_distance(name, candidate, best - 1);
    if (distance < best) {
      best = distance;
      found = candidate;
    }
  }
  return found;
}

}  // namespace smurf
