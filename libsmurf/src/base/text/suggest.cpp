// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/suggest.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace smurf {
namespace {

// Long names are rarely misspelt beyond recognition; the bound also keeps hostile input cheap.
constexpr std::size_t kLongestName = 200;
// A program generated more names than that, and looking at all of them is quadratic.
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
  int best = 0;                   ///< distance of the nearest name so far
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

}  // namespace

// Members of a class with a name outside of this file have names outside, too.
namespace suggesting {

/// Finds names with at most one edit in time that does not depend on the number of names: such
/// names are equal after one character is removed from each, or from one of them.
class Index {
 public:
  explicit Index(std::span<const std::string_view> known) : names_(known.begin(), known.end()) {
    signatures_.reserve(known.size());
    for (std::uint32_t i = 0; i < known.size(); ++i) {
      signatures_.push_back(character_bits(known[i]));
      if (known[i].size() > kLongestName) continue;
      for (const std::uint64_t hash : shortened(known[i])) places_.emplace_back(hash, i);
    }
    std::sort(places_.begin(), places_.end());
  }

  /// Whether it was made of these names.
  bool is_of(std::span<const std::string_view> known) const {
    return std::equal(known.begin(), known.end(), names_.begin(), names_.end(),
                      [](std::string_view a, std::string_view b) {
                        return a.data() == b.data() && a.size() == b.size();
                      });
  }

  std::uint64_t signature(std::size_t name) const { return signatures_[name]; }

  /// The positions of all names with at most one edit, and perhaps of others, in ascending order.
  std::vector<std::uint32_t> near(std::string_view name) const {
    std::vector<std::uint32_t> found;
    for (const std::uint64_t hash : shortened(name)) {
      auto place = std::lower_bound(places_.begin(), places_.end(), std::pair(hash, 0U));
      for (; place != places_.end() && place->first == hash; ++place) {
        found.push_back(place->second);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// The bytes of memory for the names, or more.
  static std::size_t size_for(std::span<const std::string_view> known) {
    std::size_t size = 0;
    for (const std::string_view name : known) size += 64 + 16 * std::min(name.size(), kLongestName);
    return size;
  }

 private:
  /// Hashes of the name, and of the name without each of its characters, ignoring case.
  static std::vector<std::uint64_t> shortened(std::string_view name) {
    constexpr std::uint64_t kBase = 0x100000001b3U;
    std::vector<std::uint64_t> begins{0};  // hashes of the beginnings
    std::vector<std::uint64_t> powers{1};
    for (const char c : name) {
      begins.push_back(begins.back() * kBase + static_cast<unsigned char>(lower(c)) + 1);
      powers.push_back(powers.back() * kBase);
    }
    const std::size_t size = name.size();
    std::vector<std::uint64_t> hashes{begins[size]};
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint64_t rest = begins[size] - begins[i + 1] * powers[size - i - 1];
      hashes.push_back(begins[i] * powers[size - i - 1] + rest);
    }
    return hashes;
  }

  std::vector<std::string_view> names_;
  std::vector<std::uint64_t> signatures_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> places_;  ///< sorted
};

}  // namespace suggesting

namespace {

using suggesting::Index;

/// A search for a name among many.
class Among {
 public:
  Among(std::string_view name, bool finds_ties, std::uint64_t& steps_left)
      : name_(name), steps_left_(steps_left) {
    result_.best = farthest_ + 1;
    result_.finds_ties = finds_ties;
  }

  /// False if the candidate is the name itself, or no steps remain.
  bool compare(std::string_view candidate, std::uint64_t signature) {
    if (candidate == name_) return false;
    spend(1, steps_left_);
    if (steps_left_ == 0) return false;
    if (result_.limit() < 0) return true;         // from here on, search only for the exact name
    if (differ_only_in_case(name_, candidate)) {  // nearer than all others
      result_.add(candidate, 0);
      return true;
    }
    const int limit = std::min(result_.limit(), farthest_);
    if (limit < 1 || fewest_edits(signature_, signature) > limit) return true;
    const int distance = distance_of(name_, candidate, limit, steps_left_);
    if (distance <= limit) result_.add(candidate, distance);
    return true;
  }

  std::optional<std::string_view> all(std::span<const std::string_view> known) {
    for (const std::string_view candidate : known) {
      spend(std::min(candidate.size(), kLongestName), steps_left_);
      if (!compare(candidate, character_bits(candidate))) return std::nullopt;
    }
    return result();
  }

  std::optional<std::string_view> indexed(std::span<const std::string_view> known,
                                          const Index& index) {
    for (const std::uint32_t i : index.near(name_)) {
      if (!compare(known[i], index.signature(i))) return std::nullopt;
    }
    if (result_.best <= 1 || farthest_ <= 1) return result();
    const auto size = static_cast<int>(name_.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      spend(1, steps_left_);
      const int difference = std::abs(static_cast<int>(known[i].size()) - size);
      const int limit = std::min(result_.limit(), farthest_);
      if (difference > limit || fewest_edits(signature_, index.signature(i)) > limit) continue;
      if (!compare(known[i], index.signature(i))) return std::nullopt;
    }
    return result();
  }

 private:
  std::optional<std::string_view> result() const {
    if (result_.best > farthest_ || result_.is_tied) return std::nullopt;
    return result_.nearest;
  }

  std::string_view name_;
  std::uint64_t& steps_left_;
  int farthest_ = std::max(1, static_cast<int>(name_.size()) / 3);
  std::uint64_t signature_ = character_bits(name_);
  Search result_{};
};

}  // namespace

/// The indexes of the lists in which was searched most recently.
class SuggestionIndexes::Lists {
 public:
  /// Null where an index would not pay off yet.
  const Index* find(std::span<const std::string_view> known, std::uint64_t& steps_left) {
    constexpr int kFewSearches = 4;
    if (known.size() < kFewNames) return nullptr;
    List* list = std::find_if(lists_.begin(), lists_.end(), [&](const List& one) {
      return one.begin == known.data() && one.size == known.size();
    });
    if (list == lists_.end()) {
      std::rotate(lists_.begin(), lists_.end() - 1, lists_.end());
      list = lists_.begin();
      *list = {known.data(), known.size(), 0, nullptr};
    }
    if (list->index && !list->index->is_of(known)) *list = {known.data(), known.size(), 0, nullptr};
    const bool is_needed = ++list->searches > kFewSearches || known.size() > kMostNames;
    if (!list->index && is_needed) list->index = make(known, steps_left);
    return list->index.get();
  }

  /// Null if it would take too much memory.
  static std::unique_ptr<const Index> make(std::span<const std::string_view> known,
                                           std::uint64_t& steps_left) {
    constexpr std::size_t kMostMemory = 100'000'000;
    if (Index::size_for(known) > kMostMemory) return nullptr;
    spend(known.size(), steps_left);
    return std::make_unique<Index>(known);
  }

 private:
  static constexpr std::size_t kFewNames = 100;
  struct List {
    const std::string_view* begin = nullptr;
    std::size_t size = 0;
    int searches = 0;
    std::unique_ptr<const Index> index;
  };
  std::array<List, 4> lists_;
};

SuggestionIndexes::SuggestionIndexes() : lists_(std::make_unique<Lists>()) {}
SuggestionIndexes::~SuggestionIndexes() = default;

class SuggestionSearch {
 public:
  static std::optional<std::string_view> run(std::string_view name,
                                             std::span<const std::string_view> known,
                                             bool finds_ties, std::uint64_t& steps_left,
                                             SuggestionIndexes* indexes) {
    if (name.empty() || name.size() > kLongestName) return std::nullopt;
    std::unique_ptr<const Index> own;
    const Index* index = nullptr;
    if (indexes != nullptr) {
      index = indexes->lists_->find(known, steps_left);
    } else if (known.size() > kMostNames) {
      own = SuggestionIndexes::Lists::make(known, steps_left);
      index = own.get();
    }
    Among among(name, finds_ties, steps_left);
    if (index != nullptr) return among.indexed(known, *index);
    return known.size() <= kMostNames ? among.all(known) : std::nullopt;
  }
};

int edit_distance(std::string_view a, std::string_view b, int limit) {
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  return distance_of(a, b, limit, steps);
}

std::optional<std::string_view> nearest(std::string_view name,
                                        std::span<const std::string_view> known) {
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  return SuggestionSearch::run(name, known, false, steps, nullptr);
}

std::optional<std::string_view> only_nearest(std::string_view name,
                                             std::span<const std::string_view> known,
                                             std::uint64_t& steps_left,
                                             SuggestionIndexes* indexes) {
  return SuggestionSearch::run(name, known, true, steps_left, indexes);
}

std::optional<std::string_view> only_nearest(std::string_view name,
                                             std::span<const std::string_view> known) {
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  return only_nearest(name, known, steps);
}

std::optional<std::string_view> near_name(std::string_view name,
                                          std::span<const std::string_view> known) {
  constexpr std::size_t kShort = 5;
  const int most = name.size() < kShort ? 1 : 2;
  const auto near = only_nearest(name, known);
  if (!near || differ_only_in_digits(name, *near)) return std::nullopt;
  return edit_distance(name, *near, most) <= most ? near : std::nullopt;
}

std::optional<std::vector<std::string_view>>
without_own(std::string_view name, std::string_view own, std::span<const std::string_view> known) {
  const int farthest = std::max(1, static_cast<int>(name.size()) / 3);
  if (own.empty() || own == name || edit_distance(name, own, farthest) > farthest) {
    return std::nullopt;
  }
  std::vector<std::string_view> others;
  if (known.size() > kMostValues) return others;
  others.reserve(known.size());
  std::copy_if(known.begin(), known.end(), std::back_inserter(others),
               [&](std::string_view one) { return one != own; });
  return others;
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
