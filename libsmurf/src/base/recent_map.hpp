// SPDX-License-Identifier: BSD-3-Clause
// Remembers answers about paths without growing with their number.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace smurf {

/// Keeps the values of the `kMost` names that were used last, and of at most twice as many names.
/// A search through a data set asks about a file a few times in a row, and then never again.
template <class Value>
class RecentMap {
 public:
  static constexpr std::size_t kMost = 4'096;

  /// Null if it is unknown, or forgotten. Valid until the next call of find() or add().
  const Value* find(std::string_view name) {
    if (const auto found = recent_.find(name); found != recent_.end()) return &found->second;
    const auto found = older_.find(name);
    if (found == older_.end()) return nullptr;
    auto node = older_.extract(found);
    make_room();
    return &recent_.insert(std::move(node)).position->second;
  }

  /// The value that is known from now on: the one that was there before, if any.
  const Value& add(std::string_view name, Value value) {
    if (const Value* const known = find(name)) return *known;
    make_room();
    return recent_.emplace(name, std::move(value)).first->second;
  }

  std::size_t size() const { return recent_.size() + older_.size(); }

 private:
  using Values = std::map<std::string, Value, std::less<>>;

  void make_room() {
    if (recent_.size() < kMost) return;
    older_ = std::move(recent_);
    recent_.clear();
  }

  Values recent_, older_;
};

}  // namespace smurf
