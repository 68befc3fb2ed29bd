// SPDX-License-Identifier: BSD-3-Clause
// "Did you mean": the nearest known name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace smurf {

/// Edits (insert, delete, replace, swap of neighbours) from one name to the other; names that
/// differ only in case are one edit apart. Gives up above `limit` and returns limit + 1.
int edit_distance(std::string_view a, std::string_view b, int limit);

/// The known name closest to a misspelled one: at most a third of its length in edits, or different
/// only in case. Of equally near names, the first is used. None if `name` itself is known.
std::optional<std::string_view> nearest(std::string_view name,
                                        std::span<const std::string_view> known);

/// More names than these are not searched for one that is similar: nobody misspells one of so many
/// values, and each search in them takes its time.
inline constexpr std::size_t kMostValues = 1000;

/// What makes many searches in the same long lists fast. Use one for searches that share their
/// steps.
class SuggestionIndexes {
 public:
  SuggestionIndexes();
  ~SuggestionIndexes();
  SuggestionIndexes(SuggestionIndexes&&) = delete;

 private:
  friend class SuggestionSearch;
  class Lists;
  std::unique_ptr<Lists> lists_;
};

/// The same for a suggestion: none if several names are equally near, because the first would be an
/// arbitrary choice. Each comparison of two characters costs one step. If the steps do not
/// suffice, returns none and sets them to 0.
std::optional<std::string_view> only_nearest(std::string_view name,
                                             std::span<const std::string_view> known,
                                             std::uint64_t& steps_left,
                                             SuggestionIndexes* indexes = nullptr);
std::optional<std::string_view> only_nearest(std::string_view name,
                                             std::span<const std::string_view> known);

/// The known name that a misspelt name probably means: at most two edits away (one for a name of
/// fewer than five letters), not different in digits only, and the only one so near.
std::optional<std::string_view> near_name(std::string_view name,
                                          std::span<const std::string_view> known);

/// The names without `own`, for a reference of a thing that cannot mean itself. None if `own` is
/// not near enough to the name to be suggested, or to be one of several equally near names. Empty
/// for more than kMostValues names: a copy for each of many takes a time that grows with their
/// square.
std::optional<std::vector<std::string_view>>
without_own(std::string_view name, std::string_view own, std::span<const std::string_view> known);

/// Numbered names, such as `finger_1` and `finger_3`, are not misspellings of each other.
bool differ_only_in_digits(std::string_view a, std::string_view b);

}  // namespace smurf
