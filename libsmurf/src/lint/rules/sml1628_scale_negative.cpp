// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "lint/geometry_queries.hpp"
#include "lint/habit.hpp"

namespace smurf::rules {
namespace {

/// How the left side is made of the right one: one finding a file.
void check(const LinkedModel& model, Findings& findings) {
  Habit habit;
  for_each_geometry(model, [&](const GeometryUse& use) {
    const urdf::Mesh* mesh = use.mesh();
    if (mesh == nullptr || !mesh->scale) return;
    if (std::any_of(mesh->scale->begin(), mesh->scale->end(), [](double x) { return x < 0; })) {
      habit.add(mesh->scale.span, "the mesh is mirrored by a negative scale");
    }
  });
  habit.report("such scales", findings);
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
