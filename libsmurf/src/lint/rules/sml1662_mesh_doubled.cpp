// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1662_mesh_doubled_file {
namespace {

/// A closed surface has a solid, unless each of its triangles is there twice (SurfaceSum).
bool is_doubled(const MeshFacts& facts) {
  constexpr std::uint64_t kFewest = 8;
  return !facts.defect && facts.closure == Closure::closed && !facts.solid &&
         facts.triangles >= kFewest;
}

void check(const LinkedModel& model, Findings& findings) {
  Diagnostic* diagnostic = report_meshes(
      model, [](const OpenedMesh& mesh) { return is_doubled(mesh.facts); },
      "each triangle of the mesh is there twice", "have each triangle twice", findings);
  if (diagnostic == nullptr) return;
  diagnostic->note("a program that weighs the mesh finds twice its volume");
  diagnostic->help("remove the duplicates in a mesh editor, and export it again");
}

}  // namespace

extern constinit const Rule sml1662_mesh_doubled{
    .id = "SML1662",
    .name = "mesh-doubled",
    .severity = Severity::warning,
    .summary = "A mesh has each of its triangles twice.",
    .why = "Simulators that compute masses from meshes get twice the mass, contacts are computed "
           "twice, and coinciding faces flicker.",
    .remedy = "Remove the duplicates in a mesh editor.",
    .sources = "Sums over the triangles. Triangles that face both ways are no duplicates.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1662_mesh_doubled_file
