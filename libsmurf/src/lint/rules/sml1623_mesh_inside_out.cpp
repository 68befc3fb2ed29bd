// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1623_mesh_inside_out_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  Diagnostic* diagnostic = report_meshes(
      model,
      [](const OpenedMesh& mesh) {
        return mesh.is_collision() && mesh.facts.solid && mesh.facts.solid->volume < 0;
      },
      "the mesh is turned inside out: its triangles face inward",
      "are turned inside out: their triangles face inward", findings);
  if (diagnostic != nullptr) diagnostic->help("flip the normals and export it again");
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::takes, "loads the mesh, and computes a positive mass", kRun},
};

}  // namespace

extern constinit const Rule sml1623_mesh_inside_out{
    .id = "SML1623",
    .name = "mesh-inside-out",
    .severity = Severity::warning,
    .summary = "The triangles of a closed collision mesh face inward.",
    .why = "A mass computed from the mesh is negative, and the normals point the wrong way.",
    .remedy = "Flip the normals in a mesh editor.",
    .sources = "1 of 956 public collision meshes.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1623_mesh_inside_out_file
