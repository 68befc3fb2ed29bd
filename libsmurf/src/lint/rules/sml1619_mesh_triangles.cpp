// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

constexpr std::uint64_t kMany = 10000;
constexpr std::uint64_t kManyOfVisual = 100000;
/// The largest number that MuJoCo accepts in an STL file (stl_decoder.cc:70).
constexpr std::uint64_t kMostOfMujoco = 200000;

void check_collision(const OpenedMesh& mesh, Findings& findings) {
  if (mesh.facts.triangles <= kMany) return;
  Diagnostic& diagnostic =
      findings.report(mesh.reference.span, "the collision mesh has " +
                                               std::to_string(mesh.facts.triangles) + " triangles");
  diagnostic.caret =
      "slow to collide; half of all public collision meshes have fewer than 900 triangles";
  if (mesh.facts.format != MeshFormat::stl_binary || mesh.facts.triangles <= kMostOfMujoco) return;
  diagnostic.severity = Severity::error;
  diagnostic.note("MuJoCo refuses an STL of more than 200000 triangles");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const OpenedMesh& mesh : opened_meshes(model)) {
    if (mesh.is_collision()) check_collision(mesh, findings);
  }
  Diagnostic* visuals = report_meshes(
      model,
      [](const OpenedMesh& mesh) {
        return mesh.facts.triangles > kManyOfVisual && !mesh.is_collision();
      },
      "the visual mesh has more than 100000 triangles",
      "of visuals have more than 100000 triangles", findings);
  if (visuals != nullptr) visuals->severity = Severity::info;
}

constexpr std::string_view kFormer[] = {"SML1620", "collision-triangles", "visual-triangles"};

}  // namespace

extern constinit const Rule sml1619_mesh_triangles{
    .id = "SML1619",
    .name = "mesh-triangles",
    .severity = Severity::warning,
    .summary = "A collision mesh has more than 10000 triangles, or a visual mesh more than 100000.",
    .why =
        "Contacts and distances are computed triangle by triangle in Gazebo, MARS and MoveIt: simulation and planning slow down. Of 100 public collision meshes, 96 are smaller. MuJoCo refuses an STL of more than 200000 triangles. A large visual takes long to load and to draw, most of all in a browser.",
    .remedy = "Simplify the mesh; in a collision, use its convex hull or a primitive shape.",
    .sources = "957 collision meshes of 322 public URDFs: median 854, 95 % below 8540; 733 visual "
               "meshes: 95 % below 34850, at most 82075; MuJoCo stl_decoder.cc:70.",
    .check_model = check,
    .former = kFormer};

}  // namespace smurf::rules
