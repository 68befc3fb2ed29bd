// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const PathUses& path : paths_with(model, PathFault::backslash)) {
    const MeshReference& first = path.first();
    std::string slashes(path.filename);
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    Diagnostic& diagnostic =
        findings.report(first.span, "the path " + quoted(path.filename) + " is separated by `\\`");
    diagnostic.help = "write " + quoted(slashes);
    if (first.similar.empty()) {
      diagnostic.notes.push_back("there is no file of that name either");
    } else {
      diagnostic.fixes.push_back(rewrite(path, slashes, Applicability::safe));
    }
    if (first.is_texture) diagnostic.severity = Severity::warning;
  }
}

}  // namespace

extern constinit const Rule sml1606_mesh_backslash{
    .id = "SML1606",
    .name = "mesh-backslash",
    .severity = Severity::error,
    .summary = "The path of a mesh or texture is separated by backslashes.",
    .why =
        "Only Windows takes a backslash for a separator; elsewhere it is part of a name that no file has.",
    .remedy = "Write `/`, which Windows takes too.",
    .sources = "Bullet, MuJoCo and DART, executed on Linux.",
    .check_model = check};

}  // namespace smurf::rules
