// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_meshes(
      model,
      [](const OpenedMesh& mesh) {
        constexpr std::uint64_t kMany = 100000;
        return mesh.facts.triangles > kMany && !mesh.is_collision();
      },
      "the visual mesh has more than 100000 triangles",
      "of visuals have more than 100000 triangles", findings);
}

}  // namespace

extern constinit const Rule sml1620_visual_triangles{
    .id = "SML1620",
    .name = "visual-triangles",
    .severity = Severity::info,
    .summary = "The mesh of a visual has more than 100000 triangles.",
    .why =
        "It takes long to load and to draw, most of all in a browser; no visual mesh of 322 public "
        "URDFs is as large.",
    .remedy = "Simplify the mesh.",
    .sources = "733 visual meshes of 322 public URDFs: 95 % below 34850, at most 82075.",
    .check_model = check};

}  // namespace smurf::rules
