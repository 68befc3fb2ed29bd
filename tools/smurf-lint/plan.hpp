// SPDX-License-Identifier: BSD-3-Clause
// Which files are loaded, as what, and by which configuration.
#pragma once

#include <string>

#include "smurf-lint/options.hpp"
#include "smurf/check.hpp"
#include "smurf/config.hpp"
#include "smurf/file_reader.hpp"

namespace smurf::tools {

/// `problems` have been said.
struct LintPlan : Plan {
  std::string standard_input;  ///< its name in `files`; "": it was not read
  std::size_t xacro = 0;       ///< .xacro files of the folders, which are not checked
};

/// Lets be read what the command line names and what belongs to it, which is what planning needs:
/// smurf/confine.hpp.
void confine_to_inputs(ConfinedFiles& files, const LintOptions& options);
/// Lets be read what belongs to the planned files and their configurations: a model may read the
/// same whether it is named or found in a folder.
void confine_to_found(ConfinedFiles& files, const LintOptions& options, const LintPlan& plan);

/// Lets be changed what is in the projects of the named and the found files; with --allow-outside,
/// everything.
void confine_to_changeable(ConfinedFiles& files, const LintOptions& options, const LintPlan& plan);

/// Standard input, if it is read, goes to `files`.
LintPlan make_plan(const LintOptions& options, MemoryFiles& files);

/// Leaves one part of the files. A URDF that a planned model lists goes with the model.
void keep_shard(LintPlan& plan, const Shard& shard, const FileReader& files);

/// The configuration for a file or folder: the one that the options name, else the nearest upward.
/// "" when there is none.
std::string find_config(const std::string& path, const LintOptions& options,
                        const FileReader& files);

/// Whether the user named the configuration.
inline ConfigOrigin origin_of_config(const LintOptions& options) {
  return options.config.empty() ? ConfigOrigin::found : ConfigOrigin::named;
}

}  // namespace smurf::tools
