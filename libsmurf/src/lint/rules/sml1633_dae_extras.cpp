// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1633_dae_extras_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  Diagnostic* diagnostic = report_meshes(
      model, [](const OpenedMesh& mesh) { return !mesh.facts.extras.empty(); },
      "the mesh file contains lights, cameras or animations",
      "contain lights, cameras or animations", findings);
  if (diagnostic != nullptr) diagnostic->help("export the mesh alone");
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::takes, "adds the lights to the scene of RViz", "RViz, read"},
    {&readers::gazebo, Effect::takes, "adds the lights to the scene", "gz-common, read"},
};

}  // namespace

extern constinit const Rule sml1633_dae_extras{
    .id = "SML1633",
    .name = "dae-extras",
    .severity = Severity::info,
    .summary = "A COLLADA mesh contains lights, cameras or animations.",
    .why = "Programs that add the lights to the scene show it brighter with every robot.",
    .remedy = "Export the selected mesh without the rest of the scene.",
    .sources = "207 of 932 public files.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1633_dae_extras_file
