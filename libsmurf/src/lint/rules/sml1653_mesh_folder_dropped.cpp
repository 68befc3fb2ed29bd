// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/quoted.hpp"
#include "link/mujoco_compiler.hpp"
#include "link/shape_solids.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1653_mesh_folder_dropped_file {
namespace {

bool is_lost(const MeshReference& mesh) {
  return mesh.exists && !mesh.lies_beside && !mesh.is_texture;
}

void check(const LinkedModel& model, Findings& findings) {
  const xml::View compiler = mujoco_compiler(model);
  if (compiler && (compiler.attribute("strippath") || compiler.attribute("meshdir"))) {
    return;  // SML1647
  }
  const bool has_visuals = keeps_visuals(model);
  const MeshReference* first = nullptr;
  std::size_t lost = 0;
  for_each_geometry(model, [&](const GeometryUse& use) {
    const bool is_used = use.role == GeometryRole::collision || has_visuals;
    if (!is_used || use.mesh() == nullptr || !use.mesh()->filename) return;
    const MeshReference* mesh = find_reference(model, *use.mesh());
    if (mesh == nullptr || !is_lost(*mesh)) return;
    if (lost++ == 0) first = mesh;
  });
  if (lost == 0) return;
  Diagnostic& diagnostic =
      findings.report(first->span, "the mesh " + quoted(first->filename) + " is in another folder");
  if (lost > 1) diagnostic.note("the same applies to " + std::to_string(lost - 1) + " more meshes");
  diagnostic.help(
      "add `<mujoco><compiler strippath=\"false\"/></mujoco>`, or use MuJoCo 3.7 or later");
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::refuses,
     "looks for the name of the file only, in the folder of the URDF, and refuses the model",
     "3.6.0, run", before({3, 7})},
    {&readers::mujoco, Effect::takes, "keeps the folder", kRun},
};

}  // namespace

extern constinit const Rule sml1653_mesh_folder_dropped{
    .id = "SML1653",
    .name = "mesh-folder-dropped",
    .severity = Severity::warning,
    .summary =
        "A mesh is in another folder than the URDF, which MuJoCo before 3.7 does not look at.",
    .why = "These releases keep only the name of a file, unless the element `compiler` says "
           "`strippath=\"false\"`.",
    .remedy = "Say so, or put the meshes beside the URDF.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1653_mesh_folder_dropped_file
