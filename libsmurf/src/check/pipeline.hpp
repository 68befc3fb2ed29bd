// SPDX-License-Identifier: BSD-3-Clause
// Runs rules, names places, applies comments and sorts findings. This is the only place that does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "check/group.hpp"
#include "lint/suppress.hpp"
#include "smurf/companions.hpp"

namespace smurf {

inline void append(std::vector<Diagnostic>&& from, std::vector<Diagnostic>& to) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

/// The findings in a model or scene, with the names of their places, and the comments there.
struct Judged {
  std::vector<Diagnostic> diagnostics;
  Suppressions comments;
};

/// Runs the rules. `sink` contains the findings of reading.
Judged judge(const LinkedModel& model, const SourceMap& sources, const RuleSelection& selection,
             DiagnosticSink& sink, const xacro::Expansions& expansions);
Judged judge(const Accompanied& robot, const SourceMap& sources, const RuleSelection& selection,
             DiagnosticSink& sink, const xacro::Expansions& expansions);
Judged judge(const LinkedScene& scene, const SourceMap& sources, const RuleSelection& selection,
             DiagnosticSink& sink, const xacro::Expansions& expansions);

/// The same findings with their places, also of rules that are not selected.
std::vector<Diagnostic> placed(const LinkedScene& scene, std::vector<Diagnostic> found);

/// Locates findings of other code, and applies the selection.
std::vector<Diagnostic> settle_others(const LinkedModel& model, std::vector<Diagnostic> found,
                                      const SourceMap& sources, const RuleSelection& selection,
                                      const xacro::Expansions& expansions);
std::vector<Diagnostic> settle_others(const LinkedScene& scene, std::vector<Diagnostic> found,
                                      const SourceMap& sources, const RuleSelection& selection,
                                      const xacro::Expansions& expansions);

/// The input of a report.
struct CheckContext {
  const FileReader& files;
  const Limits& limits;
  const CanonicalPaths& paths;
  std::size_t first_source = 0;  ///< the index of the first source of this report
};

/// The findings that remain under the settings of each configuration, with the findings in these.
/// `found` is by configuration; the text of a baseline is added to `sources`. Does not count models
/// and scenes.
Report make_report(std::vector<Judged>&& found, const CheckGroups& groups,
                   const CheckContext& context, SourceMap& sources);

std::string write_baseline(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources,
                           const std::string& path);

}  // namespace smurf
