// SPDX-License-Identifier: BSD-3-Clause
// A model or scene that a test loads from files in memory, with its diagnostics.
#pragma once

#include <string>
#include <vector>

#include "smurf/lint.hpp"
#include "smurf/load.hpp"

namespace smurf::test {

/// "SML3101 arm_motors.yml:3:12": short enough to compare whole lists.
std::string brief(const Diagnostic& diagnostic, const SourceMap& sources);

/// Loads and lints. Diagnostics are located, finished and kept.
struct Loaded {
  SourceMap sources;
  MemoryFiles files;
  MeshLibrary meshes;
  DiagnosticSink sink;
  LinkedModel model;
  std::vector<Diagnostic> diagnostics;

  /// Loads `path` from the files added before.
  void load(const std::string& path);
  std::vector<std::string> briefs() const;
};

/// A URDF text on its own.
std::vector<std::string> lint_urdf(const std::string& text);

}  // namespace smurf::test
