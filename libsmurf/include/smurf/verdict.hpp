// SPDX-License-Identifier: BSD-3-Clause
// The effects of findings on readers, and verdicts on files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "smurf/readers.hpp"

namespace smurf {

/// A place of a finding, for facts.
struct PlaceView {
  Span span;
  std::span<const PlaceName> names;
  const Circumstances& cases;
  std::span<const Rule* const> consequences;
  std::size_t count = 1;  ///< how many places are like this one
};

/// Calls `judge` for each place of a finding.
template <class Judge>
void for_each_place(const Diagnostic& finding, Judge&& judge) {
  const std::vector<PlaceName> read =
      finding.names.empty() ? place_of(finding) : std::vector<PlaceName>();
  judge(PlaceView{finding.span, finding.names.empty() ? read : finding.names, finding.cases,
                  finding.consequences});
  for (const Occurrence& one : finding.others) {
    judge(PlaceView{one.span, one.names, one.cases, one.consequences, one.count});
  }
}

/// The effect of a finding at one of its places, and of its consequences there, on the reader; null
/// if it is unknown. For each rule, the first fact that fits reader and place applies, in this
/// order: facts of the reader in the row of the rule, facts about the rule's family, facts of
/// Reader::like.
const Fact* find_fact(const Reader& reader, const Diagnostic& diagnostic, const PlaceView& place);
/// The worst effect of all places of a finding; null if none is known.
const Fact* find_fact(const Reader& reader, const Diagnostic& diagnostic);

/// Verdicts on files, best first.
enum class Answer : std::uint8_t { takes, loses, unknown, refuses };
std::string_view to_string(Answer answer);

/// The verdict of one reader on files, with reasons.
struct TargetVerdict {
  const Reader* reader = nullptr;
  std::size_t refusals = 0;     ///< places at which it refuses the file or crashes
  std::size_t unknown = 0;      ///< errors without a fact about it
  std::size_t losses = 0;       ///< places at which it loses or changes something
  std::size_t ignored = 0;      ///< suppressed by comments, among the deciding findings
  std::size_t in_baseline = 0;  ///< suppressed by a baseline, among the deciding findings
  const Fact* fact = nullptr;   ///< the worst effect, and its finding
  const Rule* rule = nullptr;
  Span span{};
  std::vector<const Rule*> unknown_rules{};
  /// Those of the other releases of the reader, if a finding depends on its version.
  std::vector<TargetVerdict> newer{}, earlier{};

  Answer answer() const;
  std::size_t count(Answer answer) const;
  /// Counts `count` more findings of a rule as unknown.
  void add_unknown(const Rule& of, std::size_t faults);
  /// Adds the verdict on more files.
  void add(const TargetVerdict& other);
};
/// The first later release with another answer; null if there is none.
const TargetVerdict* find_other_release(const TargetVerdict& verdict);
/// The last earlier release with another answer; null if there is none.
const TargetVerdict* find_earlier_release(const TargetVerdict& verdict);
/// Judges the findings for one target. Pass all findings, including suppressed ones.
TargetVerdict judge_target(const Reader& reader, std::span<const Diagnostic> diagnostics);

}  // namespace smurf
