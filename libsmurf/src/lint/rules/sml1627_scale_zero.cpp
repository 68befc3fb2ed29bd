// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check_shape(const urdf::Shape& shape, Findings& findings) {
  const auto* mesh = std::get_if<urdf::Mesh>(&shape);
  if (mesh == nullptr || !mesh->scale) return;
  for (const double component : *mesh->scale) {
    if (!(component == 0)) continue;
    findings.report(mesh->scale.span, "the mesh is flat in one direction: its scale has a 0");
    return;
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    for (const urdf::Visual& visual : link.visuals) check_shape(visual.geometry.shape, findings);
    for (const urdf::Collision& collision : link.collisions) {
      check_shape(collision.geometry.shape, findings);
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
