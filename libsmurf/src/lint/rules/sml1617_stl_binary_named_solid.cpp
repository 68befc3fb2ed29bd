// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1617_stl_binary_named_solid_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_meshes(
      model, [](const OpenedMesh& mesh) { return mesh.facts.named_solid; },
      "the mesh is a binary STL that begins with `solid`, like an ASCII file",
      "are binary STL that begin with `solid`, like an ASCII file", findings);
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::takes, "compares the size, and reads the file", kRun},
    {&readers::pybullet, Effect::takes, "compares the size, and reads the file", kRun},
};

}  // namespace

extern constinit const Rule sml1617_stl_binary_named_solid{
    .id = "SML1617",
    .name = "stl-binary-named-solid",
    .severity = Severity::info,
    .summary = "A binary STL file begins with the word `solid`.",
    .why = "Readers that check only the first word treat the file as ASCII and fail.",
    .remedy = "Export it again with another header.",
    .sources = "assimp STLLoader.cpp (compares the size); 21 of 1690 public files.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1617_stl_binary_named_solid_file
