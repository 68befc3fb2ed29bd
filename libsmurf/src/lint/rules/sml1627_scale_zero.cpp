// SPDX-License-Identifier: BSD-3-Clause
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

}  // namespace

extern constinit const Rule sml1627_scale_zero{
    .id = "SML1627",
    .name = "scale-zero",
    .severity = Severity::error,
    .summary = "A mesh scale has a component of 0.",
    .why = "MuJoCo and Drake refuse it, DART aborts; the mesh is flat.",
    .remedy = "Write the factor that was meant.",
    .sources = "MuJoCo 3.14 and DART 6.12, executed.",
    .check_model = check};

}  // namespace smurf::rules
