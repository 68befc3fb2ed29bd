// SPDX-License-Identifier: BSD-3-Clause
// What a reader makes of all findings in files.
#include <algorithm>
#include <iterator>
#include <utility>

#include "base/findings/readers.hpp"
#include "base/findings/uncertain.hpp"
#include "smurf/verdict.hpp"

namespace smurf {
namespace {

/// Adds a verdict, apart from those of other releases.
void add_to(TargetVerdict& sum, const TargetVerdict& other) {
  sum.refusals += other.refusals;
  sum.unknown += other.unknown;
  sum.losses += other.losses;
  for (const Rule* unknown_rule : other.unknown_rules) sum.add_unknown(*unknown_rule, 0);
  if (other.fact == nullptr) return;
  if (sum.fact != nullptr && sum.fact->effect >= other.fact->effect) return;
  sum.fact = other.fact;
  sum.rule = other.rule;
  sum.span = other.span;
}

using Releases = std::span<const Reader* const>;

Releases later_than_meant(const Reader& reader) {
  return reader.releases.empty() ? reader.releases : reader.releases.subspan(1);
}

/// The verdicts of releases. Where nothing depends on the version, they are those of the reader.
std::vector<TargetVerdict> verdicts_of(Releases releases, const TargetVerdict& verdict,
                                       const std::vector<TargetVerdict>& judged) {
  if (!judged.empty()) return judged;
  std::vector<TargetVerdict> all;
  for (const Reader* release : releases) {
    all.push_back(verdict);
    all.back().reader = release;
    all.back().newer.clear();
    all.back().earlier.clear();
  }
  return all;
}

void add_releases(Releases releases, std::vector<TargetVerdict> TargetVerdict::*member,
                  TargetVerdict& sum, const TargetVerdict& other) {
  if ((sum.*member).empty() && (other.*member).empty()) return;
  std::vector<TargetVerdict> sums = verdicts_of(releases, sum, sum.*member);
  const std::vector<TargetVerdict> others = verdicts_of(releases, other, other.*member);
  for (std::size_t i = 0; i < sums.size(); ++i) add_to(sums[i], others[i]);
  sum.*member = std::move(sums);
}

bool has_range(const Fact& fact) {
  return fact.where.from != Version{} || fact.where.until != Version{};
}

/// Whether facts about a rule, or about parts that the reader never looks at, have a range.
class DatedRules {
 public:
  explicit DatedRules(const Reader& reader) {
    for (const Reader* known = &reader; known != nullptr; known = known->like) {
      is_unread_dated_ = is_unread_dated_ || has_range_in(known->unread);
    }
  }
  bool contain(const Diagnostic& finding) const {
    if (is_unread_dated_ || is_dated(finding.rule)) return true;
    if (finding.left_out != nullptr && is_dated(finding.left_out)) return true;
    bool has_one = false;
    for_each_place(finding, [&](const PlaceView& place) {
      has_one =
          has_one || std::any_of(place.consequences.begin(), place.consequences.end(), is_dated);
    });
    return has_one;
  }

 private:
  static bool has_range_in(std::span<const Fact> facts) {
    return std::any_of(facts.begin(), facts.end(), has_range);
  }
  static bool is_dated(const Rule* rule) { return has_range_in(rule->facts); }

  bool is_unread_dated_ = false;
};

/// Whether a reader of which no fact is known may not load the file: so for every error. A warning
/// does not keep a reader from loading unless a fact says so.
bool is_open(const Diagnostic& finding) {
  if (finding.rule->needs_target) return false;
  return finding.untargeted.value_or(finding.severity) == Severity::error;
}

void add(const Diagnostic& finding, const PlaceView& place, TargetVerdict& verdict) {
  const Fact* fact = find_fact(*verdict.reader, finding, place);
  if (fact == nullptr) {
    if (is_open(finding)) verdict.add_unknown(*finding.rule, place.count);
    return;
  }
  if (fact->effect <= Effect::ignores) return;
  if (is_uncertain(*fact)) return verdict.add_unknown(*finding.rule, place.count);
  (fact->effect >= Effect::refuses ? verdict.refusals : verdict.losses) += place.count;
  if (verdict.fact != nullptr && verdict.fact->effect >= fact->effect) return;
  verdict.fact = fact;
  verdict.rule = finding.rule;
  verdict.span = place.span;
}

/// Readers are not affected by mistakes in a configuration or in comments for smurf-lint, or by the
/// losses of a converter.
bool is_about_robots(const Rule& rule) {
  return rule.reported_by == Tool::lint && !rule.id.starts_with("SML90") &&
         !rule.id.starts_with("SML91");
}

TargetVerdict judge_release(const Reader& reader, std::span<const Diagnostic> diagnostics) {
  TargetVerdict verdict;
  verdict.reader = &reader;
  for (const Diagnostic& finding : diagnostics) {
    if (!is_about_robots(*finding.rule)) continue;
    for_each_place(finding, [&](const PlaceView& place) { add(finding, place, verdict); });
  }
  return verdict;
}

bool are_same(const TargetVerdict& one, const TargetVerdict& other) {
  return one.refusals == other.refusals && one.unknown == other.unknown &&
         one.losses == other.losses && one.unknown_rules == other.unknown_rules &&
         one.fact == other.fact && one.rule == other.rule;
}

/// The verdicts of releases; none if they are all that of the reader.
std::vector<TargetVerdict> judge_releases(Releases releases, const TargetVerdict& verdict,
                                          std::span<const Diagnostic> diagnostics) {
  std::vector<TargetVerdict> judged;
  for (const Reader* release : releases) judged.push_back(judge_release(*release, diagnostics));
  const bool has_other = std::any_of(judged.begin(), judged.end(), [&](const TargetVerdict& one) {
    return !are_same(one, verdict);
  });
  return has_other ? std::move(judged) : std::vector<TargetVerdict>();
}

}  // namespace

std::string_view to_string(Answer answer) {
  switch (answer) {
  case Answer::takes: return "takes";
  case Answer::loses: return "loses";
  case Answer::unknown: return "unknown";
  case Answer::refuses: return "refuses";
  }
  return "";
}

Answer TargetVerdict::answer() const {
  if (refusals > 0) return Answer::refuses;
  if (unknown > 0) return Answer::unknown;
  return losses > 0 ? Answer::loses : Answer::takes;
}

std::size_t TargetVerdict::count(Answer answer) const {
  switch (answer) {
  case Answer::takes: return 0;
  case Answer::loses: return losses;
  case Answer::unknown: return unknown;
  case Answer::refuses: return refusals;
  }
  return 0;
}

void TargetVerdict::add_unknown(const Rule& of, std::size_t faults) {
  unknown += faults;
  const auto known = std::find(unknown_rules.begin(), unknown_rules.end(), &of);
  if (known == unknown_rules.end()) unknown_rules.push_back(&of);
}

const TargetVerdict* find_other_release(const TargetVerdict& verdict) {
  const auto other =
      std::find_if(verdict.newer.begin(), verdict.newer.end(),
                   [&](const TargetVerdict& one) { return one.answer() != verdict.answer(); });
  return other == verdict.newer.end() ? nullptr : &*other;
}

const TargetVerdict* find_earlier_release(const TargetVerdict& verdict) {
  const auto other =
      std::find_if(verdict.earlier.rbegin(), verdict.earlier.rend(),
                   [&](const TargetVerdict& one) { return one.answer() != verdict.answer(); });
  return other == verdict.earlier.rend() ? nullptr : &*other;
}

void TargetVerdict::add(const TargetVerdict& other) {
  add_releases(later_than_meant(*reader), &TargetVerdict::newer, *this, other);
  add_releases(reader->earlier, &TargetVerdict::earlier, *this, other);
  add_to(*this, other);
}

TargetVerdict judge_target(const Reader& reader, std::span<const Diagnostic> diagnostics) {
  TargetVerdict verdict = judge_release(reader, diagnostics);
  const Releases later = later_than_meant(reader);
  if (later.empty() && reader.earlier.empty()) return verdict;
  const DatedRules dated(reader);
  const bool is_dated =
      std::any_of(diagnostics.begin(), diagnostics.end(),
                  [&](const Diagnostic& finding) { return dated.contain(finding); });
  if (!is_dated) return verdict;
  verdict.newer = judge_releases(later, verdict, diagnostics);
  verdict.earlier = judge_releases(reader.earlier, verdict, diagnostics);
  return verdict;
}

}  // namespace smurf
