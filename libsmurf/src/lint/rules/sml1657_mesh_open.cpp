// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "link/inertia.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1657_mesh_open_file {
namespace {

bool is_flipped(const MeshFacts& facts) { return facts.closure == Closure::flipped; }

bool is_open(const MeshFacts& facts) {
  if (facts.closure != Closure::open || facts.solid || !facts.box) return false;
  const Vector3 size = facts.box->size();
  return size[0] > 0 && size[1] > 0 && size[2] > 0;  // SML1625 is about flat ones
}

/// Whether a reader may have to weigh the mesh, because a link that collides with it has no mass
/// or no inertia.
bool is_weighed(const OpenedMesh& mesh) {
  return std::any_of(mesh.uses.begin(), mesh.uses.end(), [](const GeometryUse& use) {
    const auto& inertial = use.link.inertial;
    return use.role == GeometryRole::collision &&
           !(inertial && inertial->mass.written && is_written(*inertial));
  });
}

Diagnostic* report(const LinkedModel& model, bool (*is_at_fault)(const MeshFacts&),
                   std::string_view one, std::string_view many, std::string_view help,
                   Findings& findings) {
  Diagnostic* diagnostic = report_meshes(
      model,
      [&](const OpenedMesh& mesh) {
        return mesh.is_collision() && !mesh.facts.defect && is_at_fault(mesh.facts) &&
               (is_flipped(mesh.facts) || is_weighed(mesh));
      },
      one, many, findings);
  if (diagnostic == nullptr) return nullptr;
  diagnostic->note("it is weighed as the box around it");
  diagnostic->help(std::string(help));
  return diagnostic;
}

void check(const LinkedModel& model, Findings& findings) {
  Diagnostic* flipped = report(
      model, is_flipped, "some triangles of the collision mesh face inward: its volume is unknown",
      "of collisions have triangles that face inward: their volumes are unknown",
      "make all normals face outward, and export it again", findings);
  if (flipped != nullptr) flipped->severity = Severity::warning;
  report(model, is_open, "the collision mesh is not closed: its volume is unknown",
         "of collisions are not closed: their volumes are unknown",
         "close the holes, or use a primitive shape", findings);
}

}  // namespace

extern constinit const Rule sml1657_mesh_open{
    .id = "SML1657",
    .name = "mesh-open",
    .severity = Severity::info,
    .summary = "A collision mesh has no volume, but its link has no mass.",
    .why = "Such a surface has holes, or triangles that face inward, and encloses no volume, so "
           "mass, centre and inertia cannot be computed from it, neither by smurf-lint nor by "
           "simulators that are asked to. Triangles that face inward are reported for all links.",
    .remedy = "Close the holes and make all normals face outward in a mesh editor, or use a "
              "primitive shape.",
    .sources = "Sums over the edges of the triangles.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1657_mesh_open_file
