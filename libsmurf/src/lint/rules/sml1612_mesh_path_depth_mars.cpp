// SPDX-License-Identifier: BSD-3-Clause
#include <functional>

#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

/// One finding for all paths that work from one of the two folders only.
void report(const LinkedModel& model, std::string_view reader,
            const std::function<bool(const MeshReference&)>& is_lost, Findings& findings) {
  const MeshReference* first = nullptr;
  std::size_t count = 0;
  for (const MeshReference& reference : model.meshes) {
    if (!is_lost(reference)) continue;
    if (first == nullptr) first = &reference;
    ++count;
  }
  if (first == nullptr) return;
  const bool is_mars = reader == "MARS";
  Diagnostic& diagnostic =
      findings.report(first->span, std::string(reader) + " cannot find " + quoted(first->filename) +
                                       (is_mars ? " from the .smurf" : ""));
  diagnostic.caret = "resolved to " + quoted(is_mars ? first->mars_path : first->path);
  diagnostic.notes.push_back((is_mars ? "URDF readers find " : "MARS, from the .smurf, finds ") +
                             quoted(is_mars ? first->path : first->mars_path));
  if (count > 1) {
    diagnostic.notes.push_back("this applies to " + std::to_string(count) + " paths of the URDF");
  }
  diagnostic.help = is_mars || !first->mars_path.ends_with(".bobj")
                        ? "keep the URDF and the .smurf in folders side by side"
                        : "add the mesh itself; only MARS reads .bobj";
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main) return;
  report(
      model, "MARS",
      [](const MeshReference& reference) {
        return reference.exists && !reference.mars_path.empty() && !reference.mars_exists;
      },
      findings);
  report(
      model, "a URDF reader",
      [](const MeshReference& reference) {
        return path_fault(reference) == PathFault::found_by_mars_only;
      },
      findings);
}

}  // namespace

extern constinit const Rule sml1612_mesh_path_depth_mars{
    .id = "SML1612",
    .name = "mesh-path-depth-mars",
    .severity = Severity::warning,
    .summary = "A relative mesh path works from the URDF or from the .smurf, but not from both.",
    .why = "MARS starts at the folder of the .smurf, and ends with an uncaught exception when a "
           "collision mesh is missing; URDF readers and Phobos start at the folder of the URDF.",
    .remedy = "Keep both files in folders side by side, such as `smurf/` and `urdf/`, and write "
              "`../meshes/x.obj`.",
    .sources =
        "MARS smurf.cpp:1080-1113, NodePhysics.cpp:626-634; Phobos and URDF readers by their "
        "documentation.",
    .check_model = check};

}  // namespace smurf::rules
