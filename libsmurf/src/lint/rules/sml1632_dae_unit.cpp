// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1632_dae_unit_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  Diagnostic* diagnostic = report_meshes(
      model,
      [](const OpenedMesh& mesh) { return mesh.facts.unit_meters && *mesh.facts.unit_meters != 1; },
      "the unit of the mesh is not the metre, which readers treat in different ways",
      "have a unit other than the metre, which readers treat in different ways", findings);
  if (diagnostic != nullptr) diagnostic->help("export it in metres");
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::changes, "applies the unit in RViz, and ignores it in MoveIt",
     "geometric_shapes mesh_operations.cpp:252-258"},
    {&readers::pybullet, Effect::takes, "applies the unit", kRun},
    {&readers::gazebo, Effect::takes, "applies the unit", "gz-common ColladaLoader.cc, read"},
    {&readers::pinocchio, Effect::changes, "ignores the unit: the shape has another size", kRun},
    {&readers::newton, Effect::changes, "ignores the unit: the shape has another size", kRun},
    {&readers::isaac, Effect::takes, "applies the unit", kRun},
};

}  // namespace

extern constinit const Rule sml1632_dae_unit{
    .id = "SML1632",
    .name = "dae-unit",
    .severity = Severity::warning,
    .summary = "The unit of a COLLADA mesh is not the metre.",
    .why =
        "Readers that ignore the unit see the mesh a hundred or a thousand times larger than those "
        "that apply it.",
    .remedy = "Export the mesh in metres.",
    .sources = "assimp 5.2, executed; about 30 of 932 public files.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1632_dae_unit_file
