// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1625_mesh_flat_file {
namespace {

bool is_flat(const MeshFacts& facts) {
  if (facts.defect || facts.triangles == 0 || !facts.box) return false;
  const Vector3 size = facts.box->size();
  return std::any_of(size.begin(), size.end(), [](double extent) { return extent == 0; });
}

void check(const LinkedModel& model, Findings& findings) {
  report_meshes(
      model, [](const OpenedMesh& mesh) { return mesh.is_collision() && is_flat(mesh.facts); },
      "the collision mesh is flat: its volume is zero",
      "of collisions are flat: their volume is zero", findings);
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "does not open meshes", kRun},
    {&readers::dart, Effect::takes, "loads it", kRun},
    {&readers::mujoco, Effect::refuses, "can make no convex hull of it, and refuses the model",
     kRun},
};

}  // namespace

extern constinit const Rule sml1625_mesh_flat{.id = "SML1625",
                                              .name = "mesh-flat",
                                              .severity = Severity::error,
                                              .summary = "The collision mesh lies in a plane.",
                                              .remedy =
                                                  "Give the mesh a thickness, or use a thin box.",
                                              .check_model = check,
                                              .facts = kFacts};

}  // namespace smurf::rules::sml1625_mesh_flat_file
