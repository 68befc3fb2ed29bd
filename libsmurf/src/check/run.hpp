// SPDX-License-Identifier: BSD-3-Clause
// One check of what is planned: scenes first, then the models no scene has loaded, then the files
// no model has read; so every file is checked in its widest context, and none twice. Within each
// of the three, files are checked in parallel, each with sources of its own, and put together in
// the order of the plan.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/canonical_paths.hpp"
#include "check/group.hpp"
#include "check/pipeline.hpp"
#include "check/snapshot.hpp"
#include "link/parsed_files.hpp"

namespace smurf {

/// What one planned file, with all that it loads, comes to.
struct Outcome {
  SourceMap sources;
  Judged judged;
  std::set<std::string> models, scenes, read;  ///< by identity
  MeshLibrary meshes;                          ///< that were opened for it
  ParsedFiles parsed;
  Recorder::Answers answers;  ///< that it depends on
  std::size_t config = 0;     ///< as PlannedFile::config
};

/// What a check leaves to the next one.
struct Memory {
  SourceMap sources;  ///< of the configurations
  CheckGroups groups;
  Recorder::Answers answers;  ///< that the configurations depend on
  CheckSettings settings;
  std::vector<std::string> configs;
  std::map<std::string, Outcome> outcomes;  ///< by the path as it was planned
  bool is_empty = true;
};

/// What a check works with.
struct Workshop {
  Desk desk;
  Snapshot* snapshot;  ///< null: nothing is kept for another check
  Memory& memory;
};

/// Checks what is planned; `sources` becomes what the report points into.
Report run_check(const Plan& plan, const CheckSettings& settings, const Workshop& workshop,
                 SourceMap& sources);

}  // namespace smurf
