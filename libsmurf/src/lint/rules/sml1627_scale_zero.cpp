// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    const urdf::Mesh* mesh = use.mesh();
    if (mesh == nullptr || !mesh->scale) return;
    for (const double component : *mesh->scale) {
      if (!(component == 0)) continue;
      findings.report(mesh->scale.span, "the mesh is flat in one direction: its scale has a 0");
      return;
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::breaks, "does not load what follows, nor the pose and the anchor",
     "MARS NodePhysics.cpp:626-634"},
    {&readers::dart, Effect::crashes, "ends the process by an assertion", kRun},
    {&readers::mujoco, Effect::refuses, "refuses a scale of 0", kRun},
    {&readers::drake, Effect::refuses, "refuses a scale below 1e-8", "Drake shape_specification.h"},
    {&readers::urdfdom, Effect::changes, "keeps a shape without volume", kRun},
};

}  // namespace

extern constinit const Rule sml1627_scale_zero{.id = "SML1627",
                                               .name = "scale-zero",
                                               .severity = Severity::error,
                                               .summary = "A mesh scale has a component of 0.",
                                               .why = "The mesh is flat.",
                                               .remedy = "Write the factor that was meant.",
                                               .check_model = check,
                                               .facts = kFacts};

}  // namespace smurf::rules
