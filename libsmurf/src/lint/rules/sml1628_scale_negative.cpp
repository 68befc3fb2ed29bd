// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1628_scale_negative_file {
namespace {

/// One finding per file, because authors mirror all parts of the left side to make the right one.
void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    const urdf::Mesh* mesh = use.mesh();
    if (mesh == nullptr || !mesh->scale) return;
    if (std::any_of(mesh->scale->begin(), mesh->scale->end(), [](double x) { return x < 0; })) {
      findings.report_habit(mesh->scale.span, "the mesh is mirrored by a negative scale",
                            "such scales");
    }
  });
}

constexpr Where kCollisionMesh = at("collision");

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::breaks,
     "stops loading here, so all later objects, the pose and the anchor are missing",
     "MARS NodePhysics.cpp:626-634"},
    {&readers::pybullet, Effect::changes, "mirrors the mesh and leaves its faces inside out", kRun},
    {&readers::dart, Effect::crashes, "ends the process with an assertion", kRun, before({6, 20})},
    {&readers::gazebo, Effect::loses,
     "loads it; DART 6.12, the default engine, ends the simulator at such a collision",
     "DART 6.12.1, run; gz-physics dartsim, read", kCollisionMesh},
    {&readers::mujoco, Effect::takes, "turns the faces with the mesh", kRun},
};

}  // namespace

extern constinit const Rule sml1628_scale_negative{.id = "SML1628",
                                                   .name = "scale-negative",
                                                   .severity = Severity::warning,
                                                   .summary = "A mesh scale is negative.",
                                                   .why = "It mirrors the mesh.",
                                                   .remedy = "Mirror the mesh file.",
                                                   .check_model = check,
                                                   .facts = kFacts,
                                                   .about = About::robot};

}  // namespace smurf::rules::sml1628_scale_negative_file
