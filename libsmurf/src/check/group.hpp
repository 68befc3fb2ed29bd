// SPDX-License-Identifier: BSD-3-Clause
// Combines settings and configurations to the selection that applies.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "smurf/check.hpp"
#include "smurf/config.hpp"

namespace smurf {

class CanonicalPaths;

/// A limit on comparisons between files and the patterns of `paths`, shared by all configurations
/// of a check.
struct PathChecks {
  std::uint64_t left = Limits{}.path_checks;
  bool is_exhausted = false;  ///< if true, patterns match nothing

  /// False if fewer remain.
  bool take(std::uint64_t count) {
    is_exhausted = is_exhausted || count > left;
    if (!is_exhausted) left -= count;
    return !is_exhausted;
  }
};

/// The selection and settings for the files of one configuration.
struct CheckGroup {
  Config config;
  RuleSelection selection;
  std::map<std::string, std::string> packages;
  std::vector<CompanionTie> ties;
  std::vector<Diagnostic> found;  ///< findings in the configuration
  CheckSettings settings;
  std::shared_ptr<PathChecks> path_checks;  ///< of the selection
};

/// The configurations of a check, in the order of Plan::configs.
using CheckGroups = std::deque<CheckGroup>;

/// Schemas of configurations point into `sources`.
CheckGroups read_configurations(const std::vector<std::string>& paths,
                                const CheckSettings& settings, const FileReader& files,
                                SourceMap& sources);
/// Fills in the selection of each group. `paths` must outlive the selections.
void merge(const CheckSettings& settings, const CanonicalPaths& paths, CheckGroups& groups);

/// The settings of the group for a whole report.
ReportSettings report_settings_of(const CheckGroup& group);

/// The targets of all groups, each once.
std::vector<const Reader*> targets_of(const CheckGroups& groups);
/// The companions that each configuration ties to robots.
std::vector<std::vector<CompanionTie>> ties_of(const CheckGroups& groups);

/// Whether two checks with these settings give the same findings for the same files. False if that
/// is unknown.
bool is_same(const CheckSettings& a, const CheckSettings& b);

}  // namespace smurf
