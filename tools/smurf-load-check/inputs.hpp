// SPDX-License-Identifier: BSD-3-Clause
// The inputs: every file is loaded once, and every model is one check.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "common/files/input.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/check.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/linked.hpp"

namespace smurf::load_check {

/// One check: of a model, or of a scene as a whole.
struct Job {
  std::string path;
  const LinkedModel* model = nullptr;   ///< null: the scene
  const LinkedScene* scene = nullptr;   ///< null: the model
  const LoadedScene* loaded = nullptr;  ///< name of its input
  /// Findings that prevent a check; then nothing is run.
  std::vector<Diagnostic> obstacles;
};

struct Inputs {
  explicit Inputs(const Limits& of_user) : limits(of_user) {}

  Limits limits;
  ConfinedFiles disk;
  tools::InputFiles read{disk};
  ArchiveFiles archives{read, limits};
  MemoryFiles files{&archives};
  Session session{files, limits};
  const SourceMap& sources = session.loaded_sources();
  std::deque<LoadedScene> scenes;  ///< the sources of the jobs
  std::vector<Job> jobs;
  bool has_failed = false;  ///< a path could not be read, which was reported
};

struct InputOptions {
  std::vector<std::string> paths;
  std::string stdin_filename;
  std::map<std::string, std::string> packages;
  bool allow_outside = false;  ///< read all files that models name
  Limits limits;
  std::uint64_t max_seconds = kMaxSeconds;
  XacroSettings xacro;
};

/// Fills `inputs`. Folders are searched as in smurf-lint; scenes come before models, and a model of
/// a scene is checked with its scene.
void load_inputs(const InputOptions& options, Inputs& inputs);

}  // namespace smurf::load_check
