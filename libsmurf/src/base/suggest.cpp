// SPDX-License-Identifier: BSD-3-Clause
#include "base/suggest.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

namespace smurf {
namespace {

// Long names are rarely misspelt beyond recognition; the bound also keeps hostile input cheap.
constexpr std::size_t kLongestName = 200;
// A program generated more names than that, and searching for each of them is quadratic.
constexpr std::size_t kMostNames = 5000;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool differ_only_in_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

/// One bit for each kind of character, ignoring case.
std::uint64_t character_bits(std::string_view text) {
  std::uint64_t bits = 0;
  for (const char c : text)
    bits |= std::uint64_t{1} << (static_cast<unsigned char>(lower(c)) % 64U);
  return bits;
}

/// Every character that occurs in only one of the names costs an edit.
int fewest_edits(std::uint64_t a, std::uint64_t b) {
  return std::max(std::popcount(a & ~b), std::popcount(b & ~a));
}

/// Skips the common beginning and end of both names.
void drop_common_ends(std::string_view& a, std::string_view& b) {
  const auto front = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const auto size = static_cast<std::size_t>(front.first - a.begin());
  a.remove_prefix(size);
  b.remove_prefix(size);
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.remove_suffix(1);
    b.remove_suffix(1);
  }
}

/// Optimal string alignment with three rows, restricted to the cells that can stay within the
/// limit.
int align(std::string_view a, std::string_view b, int limit) {
  using Row = std::array<int, kLongestName + 1>;
  std::array<Row, 3> rows;
  const int size_a = static_cast<int>(a.size());
  const int size_b = static_cast<int>(b.size());
  const int too_far = limit + 1;
  const auto at = [](std::string_view text, int i) { return text[static_cast<std::size_t>(i)]; };
  const auto cell = [](Row& row, int j) -> int& { return row[static_cast<std::size_t>(j)]; };
  for (int j = 0; j <= size_b; ++j) cell(rows[0], j) = std::min(j, too_far);
  for (int i = 1; i <= size_a; ++i) {
    Row& current = rows[static_cast<std::size_t>(i % 3)];
    Row& previous = rows[static_cast<std::size_t>((i + 2) % 3)];
    Row& before = rows[static_cast<std::size_t>((i + 1) % 3)];
    const int first = std::max(1, i - limit);
    const int last = std::min(size_b, i + limit);
    cell(current, first - 1) = first == 1 ? std::min(i, too_far) : too_far;
    int best = cell(current, first - 1);
    for (int j = first; j <= last; ++j) {
      const int above = j < i + limit ? cell(previous, j) : too_far;
      const int replaced = cell(previous, j - 1) + (at(a, i - 1) == at(b, j - 1) ? 0 : 1);
      int cost = std::min({above + 1, cell(current, j - 1) + 1, replaced});
      if (i > 1 && j > 1 && at(a, i - 1) == at(b, j - 2) && at(a, i - 2) == at(b, j - 1)) {
        cost = std::min(cost, cell(before, j - 2) + 1);
      }
      cell(current, j) = cost;
      best = std::min(best, cost);
    }
    if (best > limit) return too_far;
  }
  return std::min(cell(rows[static_cast<std::size_t>(size_a % 3)], size_b), too_far);
}

/// Subtracts the cost from `steps_left`, but not below 0.
void spend(std::uint64_t steps, std::uint64_t& steps_left) {
  steps_left -= std::min(steps, steps_left);
}

int distance_of(std::string_view a, std::string_view b, int limit, std::uint64_t& steps_left) {
  if (a == b) return 0;
  if (differ_only_in_case(a, b)) return 1;
  const auto difference = static_cast<int>(a.size()) - static_cast<int>(b.size());
  if (std::abs(difference) > limit) return limit + 1;
  drop_common_ends(a, b);
  if (a.empty() || b.empty()) return std::min(std::abs(difference), limit + 1);
  if (a.size() > kLongestName || b.size() > kLongestName) return limit + 1;
  spend(a.size() * static_cast<std::uint64_t>(2 * limit + 1), steps_left);
  return align(a, b, limit);
}

/// The search for the nearest of many names.
struct Search {
  int best;                       ///< distance of the nearest name so far
  bool is_tied = false;           ///< whether two names have this distance
  bool finds_ties = false;        ///< otherwise equally near names are not compared
  std::string_view nearest = {};  ///< the first of them

  /// The largest distance that still changes the result.
  int limit() const { return finds_ties && !is_tied ? best : best - 1; }

  void add(std::string_view candidate, int distance) {
    const bool is_repeated = nearest.data() != nullptr && candidate == nearest;
    if (is_repeated) return;  // some lists have a name twice
    is_tied = distance == best;
    if (distance < best) nearest = candidate;
    best = distance;
  }
};

std::optional<std::string_view> search(std::string_view name,
                                       std::span<const std::string_view> known, bool finds_ties,
                                       std::uint64_t& steps_left) {
  if (name.empty() || name.size() > kLongestName || known.size() > kMostNames) return std::nullopt;
  const int farthest = std::max(1, static_cast<int>(name.size()) / 3);
  Search result{.best = farthest + 1, .finds_ties = finds_ties};
  const std::uint64_t own = character_bits(name);
  for (const std::string_view candidate : known) {
    if (candidate == name) return std::nullopt;
    spend(1, steps_left);
    if (result.limit() < 0) continue;  // from here on, search only for the exact name
    spend(std::min(candidate.size(), kLongestName), steps_left);
    if (steps_left == 0) return std::nullopt;
    if (differ_only_in_case(name, candidate)) {  // nearer than all others
      result.add(candidate, 0);
      continue;
    }
    const int limit = std::min(result.limit(), farthest);
    if (limit < 1 || fewest_edits(own, character_bits(candidate)) > limit) continue;
    const int distance = distance_of(name, candidate, limit, steps_left);
    if (distance <= limit) result.add(candidate, distance);
  }
  if (result.best > farthest || result.is_tied) return std::nullopt;
  return result.nearest;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b, int limit) {
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  return distance_of(a, b, limit, steps);
}

std::optional<std::string_view> nearest(std::string_view name,
                                        std::span<const std::string_view> known) {
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  return search(name, known, false, steps);
}

std::optional<std::string_view> only_nearest(std::string_view name,
                                             std::span<const std::string_view> known,
                                             std::uint64_t& steps_left) {
  return search(name, known, true, steps_left);
}

std::optional<std::string_view> only_nearest(std::string_view name,
                                             std::span<const std::string_view> known) {
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  return only_nearest(name, known, steps);
}

bool differ_only_in_digits(std::string_view a, std::string_view b) {
  const auto without_digits = [](std::string_view text) {
    std::string rest(text);
    std::erase_if(rest, [](char c) { return c >= '0' && c <= '9'; });
    return rest;
  };
  return a != b && without_digits(a) == without_digits(b);
}

}  // namespace smurf
