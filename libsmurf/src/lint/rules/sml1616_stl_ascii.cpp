// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_meshes(
      model,
      [](const OpenedMesh& mesh) {
        return mesh.facts.format == MeshFormat::stl_ascii && mesh.is_collision();
      },
      "the mesh is an ASCII STL, which MuJoCo and Bullet refuse",
      "are ASCII STL, which MuJoCo and Bullet refuse", findings);
}

}  // namespace

extern constinit const Rule sml1616_stl_ascii{
    .id = "SML1616",
    .name = "stl-ascii",
    .severity = Severity::warning,
    .summary = "The mesh of a collision is an ASCII STL file.",
    .why =
        "MuJoCo refuses the model and Bullet leaves the shape out, as both compare the size of the file with a binary count; the others read it.",
    .remedy = "Export binary STL.",
    .sources = "MuJoCo 3.14, executed; Bullet LoadMeshFromSTL.h.",
    .check_model = check};

}  // namespace smurf::rules
