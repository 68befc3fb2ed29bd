// SPDX-License-Identifier: BSD-3-Clause
// The files to load, with their kinds and configurations.
#pragma once

#include <functional>
#include <string>

#include "common/files/output.hpp"
#include "smurf-lint/options.hpp"
#include "smurf/check.hpp"
#include "smurf/config.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/plan.hpp"

namespace smurf::tools {

/// `problems` have been reported.
struct LintPlan : FoundPlan {
  std::string standard_input;  ///< its name in `files`; "": not read
};

/// Whether the configuration and the baseline that the options name can be read; reports the first
/// that cannot.
bool can_read_named(const LintOptions& options, const FileReader& files);

/// Allows reading the files of the command line and of their projects, which planning needs:
/// smurf/confine.hpp.
void confine_to_inputs(ConfinedFiles& files, const LintOptions& options);
/// Allows reading the projects of the planned files and of their configurations, so that a model
/// may read the same files whether it is named or found in a folder.
void confine_to_found(ConfinedFiles& files, const LintOptions& options, const LintPlan& plan);

/// Allows changing files in the projects of the named and the found files; with --allow-outside,
/// all files.
void confine_to_changeable(ConfinedFiles& files, const LintOptions& options, const LintPlan& plan);

/// If standard input is an operand, its text is added to `files`. `tell` gets each problem as it is
/// found.
LintPlan make_plan(
    const LintOptions& options, MemoryFiles& files,
    const std::function<void(const std::string&)>& tell = [](const std::string& problem) {
      complain(kSmurfLint, problem);
    });

/// The configuration of a file or folder: the one that the options name, otherwise the nearest one
/// in a parent folder. "" if there is none.
std::string find_config(const std::string& path, const LintOptions& options,
                        const FileReader& files);

/// Whether the user named the configuration.
inline ConfigOrigin origin_of_config(const LintOptions& options) {
  return options.config.empty() ? ConfigOrigin::found : ConfigOrigin::named;
}

}  // namespace smurf::tools
