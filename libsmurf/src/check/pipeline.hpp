// SPDX-License-Identifier: BSD-3-Clause
// The rules, the names of places, the comments, the order: for everybody who checks, in this one
// place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "check/group.hpp"
#include "smurf/suppress.hpp"

namespace smurf {

inline void append(std::vector<Diagnostic>&& from, std::vector<Diagnostic>& to) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

/// What was found in a model or scene, with the names of the places, and the comments there.
struct Judged {
  std::vector<Diagnostic> diagnostics;
  Suppressions comments;
};

/// Runs the rules. `sink` holds what reading has found.
Judged judge(const LinkedModel& model, const SourceMap& sources, const RuleSelection& selection,
             DiagnosticSink& sink);
Judged judge(const LinkedScene& scene, const SourceMap& sources, const RuleSelection& selection,
             DiagnosticSink& sink);

/// Names the places of what somebody else has found, and applies the selection.
std::vector<Diagnostic> finish_others(const LinkedModel& model, std::vector<Diagnostic> found,
                                      const SourceMap& sources, const RuleSelection& selection);
std::vector<Diagnostic> finish_others(const LinkedScene& scene, std::vector<Diagnostic> found,
                                      const SourceMap& sources, const RuleSelection& selection);

/// What a report is made with.
struct Desk {
  const FileReader& files;
  const Limits& limits;
  const CanonicalPaths& paths;
  std::size_t first_source = 0;  ///< those before it are of other reports
};

/// What is left under the settings of each configuration, with what is wrong with these. `found`
/// is by configuration; `sources` takes the text of a baseline. Models and scenes are not counted.
Report make_report(std::vector<Judged>&& found, const CheckGroups& groups, const Desk& desk,
                   SourceMap& sources);

std::string write_baseline(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources,
                           const std::string& path);

}  // namespace smurf
