// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string_view, std::vector<const PathUses*>> by_folder;
  const std::vector<PathUses> paths = paths_with(model, PathFault::absolute);
  for (const PathUses& path : paths) {
    by_folder[path.filename.substr(0, path.filename.find_last_of("/\\"))].push_back(&path);
  }
  for (const auto& [folder, files] : by_folder) {
    const MeshReference& first = files.front()->first();
    Diagnostic& diagnostic = findings.report(first.span, "the path " + quoted(first.filename) +
                                                             " is that of one machine");
    if (!first.exists) diagnostic.caret = "not found here";
    if (first.exists || first.is_texture) diagnostic.severity = Severity::warning;
    if (files.size() > 1) {
      diagnostic.notes.push_back("the URDF names " + std::to_string(files.size()) +
                                 " files in this folder");
    }
    diagnostic.help = "write it relative to the URDF";
  }
}

}  // namespace

extern constinit const Rule sml1607_mesh_absolute{
    .id = "SML1607",
    .name = "mesh-absolute",
    .severity = Severity::error,
    .summary = "A mesh or texture is named by an absolute path.",
    .why =
        "The file is found on one machine only; where it is missing, Bullet loses the whole robot and Drake, MuJoCo, Pinocchio and DART refuse the file or the body.",
    .remedy = "Write a path relative to the URDF, or package://.",
    .sources = "Bullet, MuJoCo 3.14 and DART 6.12, executed.",
    .check_model = check};

}  // namespace smurf::rules
