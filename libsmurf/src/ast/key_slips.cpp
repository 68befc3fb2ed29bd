// SPDX-License-Identifier: BSD-3-Clause
// Reports missing and misspelt keys. Other unknown keys are allowed, because annotations are
// open.
#include <algorithm>
#include <set>

#include "ast/key_renames.hpp"
#include "ast/keys.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"

namespace smurf {
namespace {

bool is_separator(char c) { return c == '_' || c == '-' || c == ' '; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// `max_speed` and `maxSpeed`.
bool differ_in_style(std::string_view a, std::string_view b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (true) {
    while (i < a.size() && is_separator(a[i])) ++i;
    while (j < b.size() && is_separator(b[j])) ++j;
    if (i == a.size() || j == b.size()) return i == a.size() && j == b.size() && a != b;
    if (lower(a[i++]) != lower(b[j++])) return false;
  }
}

/// The known key that an unknown key probably means. Stricter than for names of things: any key is
/// allowed, and short words resemble each other by chance.
std::optional<std::string_view> meant_key(std::string_view key,
                                          std::span<const std::string_view> known) {
  constexpr std::size_t kShortest = 3;
  constexpr std::size_t kLong = 9;  // keys of this length may differ by two edits
  constexpr std::size_t kLongest = 64;
  if (key.size() > kLongest) return std::nullopt;
  for (const std::string_view other : known) {
    if (differ_in_style(key, other)) return other;
  }
  const auto near = key.size() < kShortest ? std::nullopt : nearest(key, known);
  if (!near || near->size() <= kShortest) return std::nullopt;
  const int allowed = key.size() < kLong ? 1 : 2;
  if (differ_only_in_digits(key, *near) || edit_distance(key, *near, allowed) > allowed)
    return std::nullopt;
  return near;
}

/// The place for a finding: an empty or misspelt key, else the entry's first key. Returns the
/// misspelt key.
yaml::View report_missing(const KeySpec& spec, std::span<const yaml::View> unknown,
                          yaml::View mapping, std::string_view what, KeyRenames& renames,
                          DiagnosticSink& sink) {
  std::vector<std::string_view> names;
  for (const yaml::View key : unknown) names.push_back(key.key());
  const std::string name = quoted(spec.name);
  const auto near = nearest(spec.name, names);
  const yaml::View key = mapping.find(near.value_or(spec.name));
  const Span place = key                  ? key.key_span()
                     : mapping.size() > 0 ? (*mapping.begin()).key_span()
                                          : mapping.span();
  Diagnostic& diagnostic = sink.report(rules::sml4004_missing_key, place,
                                       "this " + std::string(what) + " has no " + name);
  const bool is_empty = key && !near;
  if (is_empty) diagnostic.when(cases::kEmptyKey);
  if (spec.name == "files") diagnostic.when(cases::kLacksFiles);
  if (!key) {
    diagnostic.label(place_to_add(mapping, spec.name), "add it after this key");
  }
  if (!near) return {};
  diagnostic.help("did you mean " + name + " by `" + std::string(*near) + "`?");
  renames.offer(diagnostic.fixes, key, spec.name);
  return key;
}

/// The key of `entry` that comes before `key` in `other`; none if there is no such key.
Span place_like(yaml::View entry, yaml::View other, std::string_view key) {
  constexpr std::size_t kMostKeys = 100;  // for a linear search; SMURF entries have up to 60 keys
  if (!other.is_mapping() || entry.size() > kMostKeys || other.size() > kMostKeys) return {};
  if (!other.find(key)) return {};
  Span place;
  for (const yaml::View member : other) {
    if (member.key() == key) return place;
    if (const yaml::View own = entry.find(member.key())) place = own.key_span();
  }
  return place;
}

}  // namespace

Span place_to_add(yaml::View entry, std::string_view key) {
  constexpr int kMostOthers = 8;  // entries of one list are similar
  const yaml::Document& document = entry.document();
  const yaml::NodeId parent = document.nodes[static_cast<std::size_t>(entry.id())].parent;
  int others = 0;
  if (parent != yaml::kNoNode && yaml::View(document, parent).is_sequence()) {
    for (const yaml::View other : yaml::View(document, parent)) {
      if (++others > kMostOthers) break;
      const Span place = place_like(entry, other, key);
      if (!place.empty()) return place;
    }
  }
  Span last = entry.span();
  for (const yaml::View member : entry) last = member.key_span();
  return last;
}

void report_difference(const KeyDifference& difference, yaml::View mapping, std::string_view what,
                       DiagnosticSink& sink) {
  KeyRenames renames(mapping);
  std::vector<yaml::View> slips;
  std::set<std::string_view> meant_before;
  for (const KeySpec* spec : difference.missing) {
    slips.push_back(report_missing(*spec, difference.unknown, mapping, what, renames, sink));
    if (slips.back()) meant_before.insert(spec->name);
  }
  for (const yaml::View key : difference.unknown) {
    const auto is_this = [&](yaml::View slip) { return slip && slip.key() == key.key(); };
    if (key.is_repeated() || std::any_of(slips.begin(), slips.end(), is_this)) continue;
    const auto meant = meant_key(key.key(), difference.known);
    if (!meant || renames.has(*meant) || !meant_before.insert(*meant).second) continue;
    Diagnostic& diagnostic = sink.report(rules::sml4005_misspelt_key, key.key_span(),
                                         "no reader knows `" + std::string(key.key()) +
                                             "` in this " + std::string(what));
    diagnostic.help("did you mean `" + std::string(*meant) + "`?");
    renames.offer(diagnostic.fixes, key, *meant);
  }
}

}  // namespace smurf
