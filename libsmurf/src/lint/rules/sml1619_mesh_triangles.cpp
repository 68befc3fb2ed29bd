// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1619_mesh_triangles_file {
namespace {

constexpr Circumstance kStl{"stl"};

constexpr std::uint64_t kMany = 10000;
constexpr std::uint64_t kVeryMany = 50000;
constexpr std::uint64_t kManyOfVisual = 100000;

/// By MuJoCo, in a collision and, where it keeps them, in a visual.
bool is_refused(const OpenedMesh& mesh, bool has_visuals) {
  return (mesh.is_collision() || has_visuals) && mesh.facts.format == MeshFormat::stl_binary &&
         mesh.facts.triangles > kMostStlTrianglesOfMujoco;
}

bool is_collision_between(const OpenedMesh& mesh, std::uint64_t few, std::uint64_t many) {
  return mesh.is_collision() && !is_refused(mesh, false) && mesh.facts.triangles > few &&
         mesh.facts.triangles <= many;
}

void report_refused(const LinkedModel& model, Findings& findings) {
  const bool has_visuals = keeps_visuals(model);
  for (const OpenedMesh& mesh : opened_meshes(model)) {
    if (!is_refused(mesh, has_visuals)) continue;
    const std::string role = mesh.is_collision() ? "collision" : "visual";
    Diagnostic& diagnostic = findings.report(
        mesh.reference.span,
        "the " + role + " mesh has " + std::to_string(mesh.facts.triangles) + " triangles");
    diagnostic.when(kStl);
  }
}

void check(const LinkedModel& model, Findings& findings) {
  report_refused(model, findings);
  Diagnostic* slow = report_meshes(
      model,
      [](const OpenedMesh& mesh) { return is_collision_between(mesh, kVeryMany, UINT64_MAX); },
      "the collision mesh has more than 50000 triangles",
      "of collisions have more than 50000 triangles", findings);
  if (slow != nullptr) {
    slow->note("half of all public collision meshes have fewer than 900 triangles");
  }
  Diagnostic* large = report_meshes(
      model, [](const OpenedMesh& mesh) { return is_collision_between(mesh, kMany, kVeryMany); },
      "the collision mesh has more than 10000 triangles",
      "of collisions have more than 10000 triangles", findings);
  if (large != nullptr) large->severity = Severity::info;
  const bool has_visuals = keeps_visuals(model);
  Diagnostic* visuals = report_meshes(
      model,
      [&](const OpenedMesh& mesh) {
        return mesh.facts.triangles > kManyOfVisual && !mesh.is_collision() &&
               !is_refused(mesh, has_visuals);
      },
      "the visual mesh has more than 100000 triangles",
      "of visuals have more than 100000 triangles", findings);
  if (visuals != nullptr) visuals->severity = Severity::info;
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "loads it", "Bullet, DART, Newton and Pinocchio, run",
     when(kStl)},
    {&readers::mujoco, Effect::refuses, "refuses an STL of more than 200000 triangles",
     "MuJoCo stl_decoder.cc:70; 4.0.0, run", when(kStl)},
};

}  // namespace

extern constinit const Rule sml1619_mesh_triangles{
    .id = "SML1619",
    .name = "mesh-triangles",
    .severity = Severity::warning,
    .summary = "A collision mesh has more than 10000 triangles, or a visual mesh more than 100000.",
    .why =
        "Contacts and distances are computed triangle by triangle: simulation and planning slow "
        "down. Of 100 public collision meshes, 96 have fewer than 10000; more than 50000 are a warning. A large visual takes long "
        "to load and to draw, most of all in a browser.",
    .remedy = "Simplify the mesh (`smurf2urdf --collision lighter` does that for collisions); in a "
              "collision, use its convex hull (`--collision hull`) or a primitive shape.",
    .sources = "957 collision meshes of 322 public URDFs: median 854, 95 % below 8540; 733 visual "
               "meshes: 95 % below 34850, at most 82075.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1619_mesh_triangles_file
