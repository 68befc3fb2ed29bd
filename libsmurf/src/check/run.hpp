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

/// What a report says about a robot and its companions beside the findings.
struct OutcomeNotes {
  std::set<std::string> robots_of_srdfs = {};         ///< see Summary
  std::map<std::string, RejectedCompanion> rejected;  ///< by identity
  std::string unknown_robot;                          ///< its path, if it could not be expanded
  std::string assumption;                             ///< see Summary::assumptions
};

/// The outcome of one planned file with all files that it loads.
struct Outcome {
  SourceMap sources;
  Judged judged;
  std::set<std::string> models, scenes, read;    ///< by identity
  std::map<std::string, Claim> companions = {};  ///< of robots, by identity
  OutcomeNotes notes;
  std::set<std::string> surroundings = {};  ///< of robots, by identity
  std::string near;                         ///< see SeenCompanions::near()
  MeshLibrary meshes;                       ///< opened for it
  ParsedFiles parsed;
  Recorder::Answers answers;  ///< queries on which the result depends
  std::size_t config = 0;     ///< see PlannedFile::config
};

/// Copies the parts that the report needs from an outcome that is kept for the next check.
inline Outcome copy_of(const Outcome& kept) {
  Outcome copy;
  copy.sources = kept.sources;
  copy.judged = kept.judged;
  copy.models = kept.models;
  copy.companions = kept.companions;
  copy.surroundings = kept.surroundings;
  copy.notes = kept.notes;
  copy.scenes = kept.scenes;
  copy.read = kept.read;
  return copy;
}

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
