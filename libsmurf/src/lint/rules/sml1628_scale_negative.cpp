// SPDX-License-Identifier: BSD-3-Clause
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    const urdf::Mesh* mesh = use.mesh();
    if (mesh == nullptr || !mesh->scale) return;
    for (const double component : *mesh->scale) {
      if (!(component < 0)) continue;
      findings.report(mesh->scale.span, "the mesh is mirrored by a negative scale");
      return;
    }
  });
}

}  // namespace

extern constinit const Rule sml1628_scale_negative{
    .id = "SML1628",
    .name = "scale-negative",
    .severity = Severity::warning,
    .summary = "A mesh scale is negative.",
    .why = "It mirrors the mesh; only MuJoCo turns the faces with it, DART aborts the process.",
    .remedy = "Mirror the mesh file.",
    .sources = "DART 6.12 and MuJoCo 3.14, executed.",
    .check_model = check};

}  // namespace smurf::rules
