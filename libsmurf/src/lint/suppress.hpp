// SPDX-License-Identifier: BSD-3-Clause
// Suppressed findings: by a comment at the place, or in a baseline file.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/companions.hpp"
#include "smurf/lint.hpp"
#include "smurf/xacro.hpp"

namespace smurf {

/// Comments that silence rules, in YAML and XML files:
///
///     # smurf-lint: ignore[SML3101, unknown-link] reason
///     <!-- smurf-lint: ignore-file[SML19] reason -->
///
/// The first form applies to its line or, on a line of its own, to the whole next entry.
///
/// Rules are named by id, name or prefix of ids. No form applies to all rules.
class Suppressions {
 public:
  /// Comments of xacro files are read in those files, not in the expansions.
  void add(const LinkedModel& model, const SourceMap& sources, const xacro::Expansions& expansions);
  void add(const LinkedScene& scene, const SourceMap& sources, const xacro::Expansions& expansions);
  void add(const Companions& companions, const SourceMap& sources);
  /// Adds the comments of another part of the run. Call it after merging its sources.
  void take(Suppressions&& other, const SourceShift& shift);

  /// Removes suppressed findings and returns their number. Reports mistakes in the comments:
  /// malformed comments, unknown rules, and comments without effect. The last are reported only for
  /// completely read models, and for rules that `selection` runs. Precondition: the diagnostics are
  /// finished; finish them again afterwards.
  std::size_t apply(std::vector<Diagnostic>& diagnostics, const SourceMap& sources,
                    const RuleSelection& selection);

 private:
  struct Item {
    Span span;         ///< of the id as written
    Span removal;      ///< delete this to remove the item alone
    std::string name;  ///< id, name or prefix
    bool is_used = false;
  };
  struct Comment {
    Span span;
    Span removal;         ///< delete this to remove the comment
    std::uint32_t begin;  ///< of the bytes it applies to
    std::uint32_t end;
    std::string problem;  ///< the reason why the comment is malformed; other members are then empty
    std::vector<Item> items;
    std::string rule_named;  ///< the first rule in its text, for the advice about a problem
  };
  struct File {
    std::vector<Comment> comments;
    bool is_complete = true;  ///< all rules have run on it
  };
  class Reader;

  template <class Document>
  void add(const Document& document, bool is_complete, const SourceMap& sources);
  /// Marks the items that have an effect; returns the indices of the findings that they suppress.
  static std::vector<std::size_t> silence(std::span<const Diagnostic> diagnostics,
                                          std::vector<Comment>& comments);
  static void judge(const Comment& comment, const std::function<bool(const Item&)>& is_unused,
                    DiagnosticSink& sink);

  std::map<std::string, File> files_;  ///< by path
};

/// False for mistakes in configurations, comments and baselines (SML9). They have no pointer, so
/// one entry would suppress all of them.
bool may_be_in_baseline(const Diagnostic& diagnostic);

/// The comment that suppresses a finding in a file: at the end of its line, else above its entry.
/// None if both are impossible.
std::optional<Edit> suppress_here(const Diagnostic& diagnostic, const yaml::Document& document,
                                  std::string_view text);
std::optional<Edit> suppress_here(const Diagnostic& diagnostic, const xml::Document& document,
                                  std::string_view text);

/// The name of a file in a baseline: its path relative to the folder of the baseline.
using BaselinePath = std::function<std::string(const std::string& path)>;

/// Findings at the time when the baseline was written:
///
///     smurf/arm_motors.yml:
///       SML3101:
///       - /motors/name=elbow/joint
///
/// A finding is recognised by file, rule and named pointer, so lines and entries may move. A new
/// finding that equals a recorded one is one too many, and is reported.
class Baseline {
 public:
  explicit Baseline(BaselinePath name_of) : name_of_(std::move(name_of)) {}

  /// Reports mistakes in the file.
  void read(const yaml::Document& document, DiagnosticSink& sink);
  /// Removes recorded findings and returns their number. Precondition: as Suppressions::apply.
  std::size_t apply(std::vector<Diagnostic>& diagnostics, const SourceMap& sources);
  /// Reports the entries of rules that ran, if no finding of a file in `sources` matched them.
  void report_stale(const SourceMap& sources, const RuleSelection& selection,
                    DiagnosticSink& sink) const;

  /// Whether a text is a baseline that write() made: only baselines may be overwritten.
  static bool is_written(std::string_view text);
  /// The text of a baseline of these findings.
  std::string write(std::span<const Diagnostic> diagnostics, const SourceMap& sources) const;

 private:
  struct Entry {
    Span span;
    bool is_used = false;
  };
  template <class Value>
  using ByName = std::map<std::string, Value, std::less<>>;

  void read_file(yaml::View rules, DiagnosticSink& sink);

  BaselinePath name_of_;
  /// Ordered by file, then id of the rule, then named pointer, so a long file name is kept once.
  ByName<ByName<ByName<std::vector<Entry>>>> entries_;
};

}  // namespace smurf
