// SPDX-License-Identifier: BSD-3-Clause
// Checks the planned files: scenes first, then models that no scene has loaded, then files that no
// model has read. So every file is checked once, in its widest context. Within each of the three
// groups, files are checked in parallel, each with its own sources, and combined in the order of
// the plan.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/files/canonical_paths.hpp"
#include "check/group.hpp"
#include "check/pipeline.hpp"
#include "check/shared_companions.hpp"
#include "check/snapshot.hpp"
#include "link/parsed_files.hpp"

namespace smurf {

/// The outcome of one planned file with all files that it loads.
struct Outcome {
  SourceMap sources;
  Judged judged;
  std::set<std::string> models, scenes, read;           ///< by identity
  std::map<std::string, CompanionFit> companions = {};  ///< of robots, by identity
  std::set<std::string> robots_of_srdfs = {};           ///< see Summary
  MeshLibrary meshes;                                   ///< opened for it
  ParsedFiles parsed;
  Recorder::Answers answers;  ///< queries on which the result depends
  std::size_t config = 0;     ///< see PlannedFile::config
};

/// The results that a check keeps for the next one.
struct Memory {
  SourceMap sources;  ///< of the configurations
  CheckGroups groups;
  Recorder::Answers answers;  ///< queries on which the configurations depend
  CheckSettings settings;
  std::vector<std::string> configs;
  std::map<std::string, Outcome> outcomes;  ///< by the planned path
  bool is_empty = true;
};

/// The input of a check.
struct RunContext {
  CheckContext check;
  Snapshot* snapshot;  ///< null: keep nothing for another check
  Memory& memory;
};

/// Checks the planned files. The report points into `sources`.
Report run_check(const Plan& plan, const CheckSettings& settings, const RunContext& context,
                 SourceMap& sources);

}  // namespace smurf
