// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_meshes(
      model, [](const OpenedMesh& mesh) { return mesh.facts.named_solid; },
      "the mesh is a binary STL that begins with `solid`, like an ASCII file",
      "are binary STL that begin with `solid`, like an ASCII file", findings);
}

}  // namespace

extern constinit const Rule sml1617_stl_binary_named_solid{
    .id = "SML1617",
    .name = "stl-binary-named-solid",
    .severity = Severity::info,
    .summary = "A binary STL file begins with the word `solid`.",
    .why = "Readers that check only the first word treat the file as ASCII and fail; MuJoCo, "
           "Bullet and assimp compare the size and read the file.",
    .remedy = "Export it again with another header.",
    .sources = "assimp STLLoader.cpp, Bullet LoadMeshFromSTL.h; 21 of 1690 public files.",
    .check_model = check};

}  // namespace smurf::rules
