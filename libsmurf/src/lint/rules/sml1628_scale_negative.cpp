// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check_shape(const urdf::Shape& shape, Findings& findings) {
  const auto* mesh = std::get_if<urdf::Mesh>(&shape);
  if (mesh == nullptr || !mesh->scale) return;
  for (const double component : *mesh->scale) {
    if (!(component < 0)) continue;
    findings.report(mesh->scale.span, "the mesh is mirrored by a negative scale");
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
