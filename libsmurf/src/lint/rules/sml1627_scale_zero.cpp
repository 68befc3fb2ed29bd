// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1627_scale_zero_file {
namespace {

constexpr Circumstance kTiny{"tiny"};
constexpr Circumstance kZero{"zero"};

double volume_of(const Vector3& edges) { return std::fabs(edges[0] * edges[1] * edges[2]); }

/// The volume of the mesh at most, in the unit of the file: that of its box where the surface is
/// open, or where the volumes of its sides cancel, because each face is there from both sides.
/// MuJoCo adds up their sizes. None of a flat mesh, which is another defect.
std::optional<double> unscaled_volume(const LinkedModel& model, const urdf::Mesh& mesh) {
  const MeshFacts* facts = find_facts(model, mesh);
  if (facts == nullptr || facts->defect || !facts->box) return std::nullopt;
  const double around = volume_of(facts->box->size());
  if (around == 0) return std::nullopt;
  constexpr double kCancelled = 1e-6;  // of the box
  const double inside = facts->solid ? std::fabs(facts->solid->volume) : around;
  return inside > kCancelled * around ? inside : around;
}

void check_mesh(const LinkedModel& model, const urdf::Mesh& mesh, Findings& findings) {
  constexpr double kSmallest = 1e-15;  // m^3, mjMINVAL
  const double factor = volume_of(*mesh.scale);
  if (ranges::contains(*mesh.scale, 0)) {
    findings.report(mesh.scale.span, "the mesh is flat in one direction: its scale has a 0")
        .when(kZero);
    return;
  }
  const auto volume = unscaled_volume(model, mesh);
  if (!volume || *volume * factor >= kSmallest) return;
  Diagnostic& diagnostic = findings.report(
      mesh.scale.span, "its scale leaves a mesh of " + format_rounded(*volume * factor, 3) + " m3");
  diagnostic.when(kTiny);
  diagnostic.severity = Severity::warning;
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    const urdf::Mesh* mesh = use.mesh();
    if (mesh != nullptr && mesh->scale) check_mesh(model, *mesh, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "keeps a shape without volume", kRun},
    {&readers::mars, Effect::breaks,
     "stops loading here, so all later objects, the pose and the anchor are missing",
     "MARS NodePhysics.cpp:626-634", when(kZero)},
    {&readers::dart, Effect::takes, "keeps the scale", kRun, when(kTiny)},
    {&readers::dart, Effect::crashes, "ends the process with an assertion", kRun, before({6, 20})},
    {&readers::mujoco, Effect::changes, "keeps a shape without volume", "3.2.7, run",
     before({3, 3})},
    {&readers::mujoco, Effect::refuses, "refuses a mesh of less than 1e-15 m3", kRun, when(kTiny)},
    {&readers::mujoco, Effect::refuses, "refuses a scale of 0", kRun},
    {&readers::drake, Effect::refuses, "refuses a scale below 1e-8",
     "Drake shape_specification.h, run"},
    {&readers::urdfdom, Effect::takes, "keeps the scale", kRun, when(kTiny)},
    {&readers::urdfdom, Effect::changes, "keeps a shape without volume", kRun},
};

}  // namespace

extern constinit const Rule sml1627_scale_zero{
    .id = "SML1627",
    .name = "scale-zero",
    .severity = Severity::error,
    .summary = "A mesh scale has a component of 0, or makes the mesh tiny.",
    .why = "The mesh is flat, or smaller than any part of a robot.",
    .remedy = "Write the factor that was meant.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1627_scale_zero_file
