// SPDX-License-Identifier: BSD-3-Clause
// Checks the planned files: scenes first, then models that no scene has loaded, then files that no
// model has read. So every file is checked once, in its widest context. Within each of the three
// groups, files are checked in parallel, each with its own sources, and combined in the order of
// the plan.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/files/canonical_paths.hpp"
#include "check/group.hpp"
#include "check/in_time.hpp"
#include "check/pipeline.hpp"
#include "check/shared_companions.hpp"
#include "check/snapshot.hpp"
#include "link/parsed_files.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// What a report says about a robot and its companions beside the findings.
struct OutcomeNotes {
  std::set<std::string> robots_of_srdfs = {};         ///< see Summary
  std::map<std::string, RejectedCompanion> rejected;  ///< by identity
  std::string unknown_robot;                          ///< its path, if it could not be expanded
  std::string assumption;                             ///< see Summary::assumptions
  std::set<Language> languages;                       ///< of robots that were expanded
  std::set<std::string> arguments;                    ///< of xacro
  std::optional<RobotSize> size;                      ///< of the robot
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
  std::uint32_t config = 0;   ///< see PlannedFile::config
};

/// The key of an outcome. A xacro file is checked with several sets of arguments.
inline std::string key_of(const PlannedFile& planned) {
  std::string key = planned.path;
  if (planned.arguments == nullptr) return key;
  for (const auto& [name, value] : planned.arguments->values) key += "\n" + name + ":=" + value;
  return key;
}

/// Those of its arguments that have several values; "" if there are none.
inline std::string shown_arguments(const PlannedFile& planned) {
  return planned.arguments == nullptr ? std::string() : planned.arguments->shown;
}

/// The outcome of a file that takes too long: one finding.
inline Outcome outcome_out_of_time(const PlannedFile& planned, const std::string& identity,
                                   std::uint64_t seconds, const SourceMap& sources) {
  Outcome outcome;
  outcome.sources = sources;
  outcome.config = planned.config;
  DiagnosticSink sink;
  Diagnostic& left = report_out_of_time(planned.path, seconds, outcome.sources, sink);
  if (const std::string shown = shown_arguments(planned); !shown.empty())
    left.note("with " + shown);
  outcome.judged.diagnostics = sink.take();
  outcome.read.insert(identity);
  const InputKind kind = input_kind(planned.path);
  const bool is_scene = kind == InputKind::scene || kind == InputKind::drawing;
  if (kind != InputKind::annotation) (is_scene ? outcome.scenes : outcome.models).insert(identity);
  return outcome;
}

inline void shift(Diagnostic& diagnostic, const SourceShift& by) {
  diagnostic.span = by(diagnostic.span);
  diagnostic.call = by(diagnostic.call);
  if (diagnostic.expanded) diagnostic.expanded = by(*diagnostic.expanded);
  for (Label& label : diagnostic.labels) label.span = by(label.span);
  for (Fix& fix : diagnostic.fixes) {
    for (Edit& edit : fix.edits) edit.span = by(edit.span);
  }
}

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
