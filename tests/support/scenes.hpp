// SPDX-License-Identifier: BSD-3-Clause
// Scenes from files in memory or from the fixtures, and 4x4 matrices that do not use our pose code.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "smurf/archive_files.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"

namespace smurf::test {

/// A scene that was loaded and linted. Diagnostics are located, finished and kept.
struct LoadedScene {
  SourceMap sources;
  DiskFiles disk;
  MemoryFiles files{&disk};
  ArchiveFiles archives{files, Limits{}};
  DiagnosticSink sink;
  Limits limits;
  LinkedScene scene;
  std::vector<Diagnostic> diagnostics;

  /// "box.urdf" has the links base and lid; lid is 0.1 m above base. "crane.smurf" has a hinge
  /// `boom_joint` about y at z = 1 m, a hook 2 m along the boom, and the joint pose set `up`.
  LoadedScene();

  void load(const std::string& path);
  /// A scene of one text, loaded as "scene.smurfs".
  void load_text(const std::string& text);
  /// "SML5101 scene.smurfs:3:37", one per line.
  std::string briefs() const;
  /// The instance with this path; fails the test if there is none.
  const Instance& at(const std::string& path) const;
};

/// Row-major.
using Matrix = std::array<double, 16>;
Matrix operator*(const Matrix& a, const Matrix& b);
Matrix translation(double x, double y, double z);
/// Radians.
Matrix rotation_x(double angle);
Matrix rotation_y(double angle);
Matrix rotation_z(double angle);
/// The quaternion need not have unit length.
Matrix rotation(double w, double x, double y, double z);
double radians(double degrees);
Matrix to_matrix4(const Pose& pose);
/// The largest difference of two elements.
double difference(const Matrix& a, const Matrix& b);

}  // namespace smurf::test
