// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1612_mesh_path_depth_mars_file {
namespace {

/// One finding for all paths that MARS does not find. SML1604 reports those that only MARS finds.
void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main) return;
  const MeshReference* first = nullptr;
  std::size_t count = 0;
  for (const MeshReference* reference : collisions_first(model)) {
    if (!reference->exists || reference->mars_path.empty() || reference->mars_exists) continue;
    if (first == nullptr) first = reference;
    ++count;
  }
  if (first == nullptr) return;
  Diagnostic& diagnostic = findings.report(
      first->span, "MARS cannot find " + quoted(first->filename) + " from the .smurf");
  diagnostic.caret = "resolved to " + quoted(first->mars_path);
  diagnostic.note("URDF readers find " + quoted(first->path));
  if (count > 1) {
    diagnostic.note("this applies to " + std::to_string(count) + " paths of the URDF");
  }
  diagnostic.help("keep the URDF and the .smurf in folders side by side");
}

constexpr Fact kFacts[] = {kMarsWithoutCollision, mars_without_mesh()};

}  // namespace

extern constinit const Rule sml1612_mesh_path_depth_mars{
    .id = "SML1612",
    .name = "mesh-path-depth-mars",
    .severity = Severity::warning,
    .summary = "MARS does not find a mesh that URDF readers find.",
    .why =
        "A relative path starts at the folder of the .smurf for one reader, and at the folder of the URDF for all others.",
    .remedy = "Keep both files in folders side by side, such as `smurf/` and `urdf/`, and write "
              "`../meshes/x.obj`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1612_mesh_path_depth_mars_file
