// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/join.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/text/counted.hpp"
#include "smurf/verdict.hpp"

namespace smurf {
namespace {

/// What the findings of one cause have in common: the rule, the file or the place in the xacro, and
/// how a habit is called.
using Key = std::tuple<const Rule*, bool, SourceId, SourceId, std::uint32_t, std::uint32_t>;

bool is_joined(const Diagnostic& one) { return one.expanded || !one.others_are.empty(); }

Key key_of(const Diagnostic& one) {
  const SourceId robot = one.expanded ? one.expanded->source : one.span.source;
  if (!one.others_are.empty()) return {one.rule, true, robot, robot, one.habit, 0};
  return {one.rule, false, robot, one.span.source, one.span.begin, one.span.end};
}

bool is_alike(const Occurrence& a, const Occurrence& b) {
  return a.names == b.names && a.cases == b.cases && a.consequences == b.consequences;
}

Occurrence own_place(const Diagnostic& one) {
  return {one.span, place_of(one), one.cases, one.consequences};
}

void add_place(Occurrence place, std::vector<Occurrence>& places) {
  const auto known = std::find_if(places.begin(), places.end(),
                                  [&](const Occurrence& one) { return is_alike(one, place); });
  if (known == places.end()) {
    places.push_back(std::move(place));
  } else {
    known->count += place.count;
  }
}

bool is_same_fix(const Diagnostic& a, const Diagnostic& b) {
  if (a.fixes.size() != b.fixes.size()) return false;
  for (std::size_t i = 0; i < a.fixes.size(); ++i) {
    const auto& [left, right] = std::tie(a.fixes[i].edits, b.fixes[i].edits);
    const bool is_same = std::equal(
        left.begin(), left.end(), right.begin(), right.end(),
        [](const Edit& x, const Edit& y) { return x.span == y.span && x.text == y.text; });
    if (!is_same) return false;
  }
  return true;
}

/// The findings of one cause.
struct Joined {
  std::size_t first = 0;  ///< its place in the list
  std::size_t others = 0;
  std::vector<Span> calls;
};

/// A habit is fixed everywhere or nowhere; at the place of a macro, one fix serves all calls.
void join_fixes(const Diagnostic& other, Diagnostic& first) {
  if (first.others_are.empty() || first.fixes.size() != 1 || other.fixes.size() != 1) {
    if (!is_same_fix(first, other)) first.fixes.clear();
    return;
  }
  std::vector<Edit>& edits = first.fixes.front().edits;
  const std::vector<Edit>& more = other.fixes.front().edits;
  edits.insert(edits.end(), more.begin(), more.end());
}

/// Calls of one macro fix the same bytes.
void drop_repeated(std::vector<Edit>& edits) {
  const auto key = [](const Edit& one) {
    return std::tie(one.span.source, one.span.begin, one.span.end, one.text);
  };
  std::stable_sort(edits.begin(), edits.end(),
                   [&](const Edit& a, const Edit& b) { return key(a) < key(b); });
  edits.erase(std::unique(edits.begin(), edits.end(),
                          [&](const Edit& a, const Edit& b) { return key(a) == key(b); }),
              edits.end());
}

/// The first of the most severe places speaks.
void join(Diagnostic other, Diagnostic& first, Joined& cause) {
  ++cause.others;
  if (other.severity > first.severity) {
    other.others = std::exchange(first.others, {});
    std::swap(first, other);
  }
  add_place(own_place(other), first.others);
  if (other.untargeted) {
    first.untargeted = std::max(first.untargeted.value_or(*other.untargeted), *other.untargeted);
  }
  join_fixes(other, first);
  const bool is_known =
      other.call.empty() || other.call == first.call ||
      std::find(cause.calls.begin(), cause.calls.end(), other.call) != cause.calls.end();
  if (!is_known) cause.calls.push_back(other.call);
}

std::string text_of(const SourceMap& sources, Span call) {
  return sources.path(call.source) + ":" + std::to_string(sources.line_of(call.source, call.begin));
}

/// "also in 3 other calls: base.xacro:41, base.xacro:42, ..."
std::string other_calls(const SourceMap& sources, const Joined& cause) {
  constexpr std::size_t kMost = 5;
  const std::vector<Span>& calls = cause.calls;
  std::string text = "also in " + counted(cause.others, "other place") + " of the robot";
  for (std::size_t i = 0; i < std::min(calls.size(), kMost); ++i) {
    text += (i == 0 ? ", from calls at " : ", ") + text_of(sources, calls[i]);
  }
  return calls.size() > kMost ? text + ", ..." : text;
}

/// "1 more such name in this file"
std::string more_in_file(std::size_t count, std::string_view others) {
  if (count == 1) others.remove_suffix(1);
  return std::to_string(count) + " more " + std::string(others) + " in this file";
}

}  // namespace

void join_places(std::vector<Diagnostic>& found, const SourceMap& sources) {
  if (std::none_of(found.begin(), found.end(), is_joined)) return;
  std::map<Key, Joined> causes;
  std::vector<Diagnostic> kept;
  kept.reserve(found.size());
  for (Diagnostic& one : found) {
    if (!is_joined(one)) {
      kept.push_back(std::move(one));
      continue;
    }
    const auto [cause, is_new] = causes.try_emplace(key_of(one));
    if (is_new) {
      cause->second.first = kept.size();
      kept.push_back(std::move(one));
    } else {
      join(std::move(one), kept[cause->second.first], cause->second);
    }
  }
  for (const auto& [key, cause] : causes) {
    if (cause.others == 0) continue;
    Diagnostic& first = kept[cause.first];
    for (Fix& fix : first.fixes) drop_repeated(fix.edits);
    first.note(first.others_are.empty() ? other_calls(sources, cause)
                                        : more_in_file(cause.others, first.others_are));
  }
  found = std::move(kept);
}

void join_same(Diagnostic& kept, const Diagnostic& same) {
  std::vector<Occurrence> places = {own_place(same)};
  for (const Occurrence& one : same.others) add_place(one, places);
  const Occurrence own = own_place(kept);
  for (Occurrence& place : places) {
    if (is_alike(place, own)) --place.count;
    const auto known = std::find_if(kept.others.begin(), kept.others.end(),
                                    [&](const Occurrence& one) { return is_alike(one, place); });
    if (known != kept.others.end()) {
      known->count = std::max(known->count, place.count);
    } else if (place.count > 0) {
      kept.others.push_back(std::move(place));
    }
  }
}

}  // namespace smurf
