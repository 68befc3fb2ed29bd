// SPDX-License-Identifier: BSD-3-Clause
// The few algorithms of std::ranges that the project uses: the libc++ of Emscripten and of older
// Apple systems lacks them.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>

namespace smurf::ranges {

template <class Range, class Predicate>
auto find_if(Range&& range, const Predicate& is_sought) {
  return std::find_if(std::begin(range), std::end(range), is_sought);
}

/// The first item whose `member` is equal to the value.
template <class Range, class Value, class Member>
auto find(Range&& range, const Value& value, Member member) {
  return find_if(range, [&](const auto& item) { return std::invoke(member, item) == value; });
}

template <class Range, class Predicate>
bool any_of(const Range& range, const Predicate& is_sought) {
  return std::any_of(std::begin(range), std::end(range), is_sought);
}

template <class Range, class Value>
bool contains(const Range& range, const Value& value) {
  return std::find(std::begin(range), std::end(range), value) != std::end(range);
}

}  // namespace smurf::ranges
