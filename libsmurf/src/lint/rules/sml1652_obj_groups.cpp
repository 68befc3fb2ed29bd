// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1652_obj_groups_file {
namespace {

constexpr Circumstance kFlat{"flat first group"};

void report(const LinkedModel& model, bool is_flat, Findings& findings) {
  Diagnostic* diagnostic = report_meshes(
      model,
      [&](const OpenedMesh& mesh) {
        return mesh.is_collision() && mesh.facts.has_more_groups &&
               mesh.facts.is_first_group_flat == is_flat;
      },
      is_flat ? "the first group of the collision mesh is flat"
              : "the collision mesh has several groups",
      is_flat ? "of collisions have a flat first group" : "of collisions have several groups",
      findings);
  if (diagnostic == nullptr) return;
  if (is_flat) diagnostic->when(kFlat);
  diagnostic->note("each line `o` or `g` begins a group");
  diagnostic->help("write the mesh as one group, or one file for each group");
}

void check(const LinkedModel& model, Findings& findings) {
  report(model, true, findings);
  report(model, false, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::refuses,
     "reads the faces of the first group only, finds no volume, and refuses the model",
     "3.3.7, run; 3.1.6 loads it", when(kFlat).since({3, 3})},
    {&readers::mujoco, Effect::changes,
     "reads the faces of the first group only: its volume and inertia are wrong", kRun},
};

}  // namespace

extern constinit const Rule sml1652_obj_groups{
    .id = "SML1652",
    .name = "obj-groups",
    .severity = Severity::warning,
    .summary = "An OBJ file for collisions has faces in several groups.",
    .remedy = "Join the groups, or write one file for each.",
    .sources = "148 of 579 collision meshes of 70 repositories.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1652_obj_groups_file
