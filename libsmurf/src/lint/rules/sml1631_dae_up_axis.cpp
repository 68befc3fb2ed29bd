// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1631_dae_up_axis_file {
namespace {

constexpr Circumstance kGltf{"glTF"};

void check(const LinkedModel& model, Findings& findings) {
  Diagnostic* diagnostic = report_meshes(
      model,
      [](const OpenedMesh& mesh) {
        return mesh.facts.format == MeshFormat::collada && mesh.facts.up_axis != 'Z' &&
               !mesh.facts.defect;
      },
      "the up axis of the mesh is not Z, and readers treat that in different ways",
      "have an up axis other than Z, which readers treat in different ways", findings);
  if (diagnostic != nullptr) diagnostic->help("export it with Z up");
  Diagnostic* gltf = report_meshes(
      model,
      [](const OpenedMesh& mesh) {
        return mesh.facts.format == MeshFormat::gltf && !mesh.facts.defect &&
               mesh.file.lost.empty();
      },
      "y is up in a glTF, and not all readers turn it to z",
      "are glTF, in which y is up, and not all readers turn it to z", findings);
  if (gltf == nullptr) return;
  gltf->when(kGltf);
  gltf->severity = Severity::info;
  gltf->note("smurf-view and the conversions turn it");
  gltf->help("where it lies on its side, export a COLLADA or OBJ with Z up");
}

constexpr std::string_view kDoesNotTurn = "does not rotate the mesh";

constexpr Fact kFacts[] = {
    {&readers::pinocchio, Effect::changes, "does not turn y up to z up", kRun, when(kGltf)},
    {&readers::newton, Effect::changes, "does not turn y up to z up", kRun, when(kGltf)},
    {&readers::drake, Effect::takes, "turns y up to z up", "Drake's documentation of Mesh",
     when(kGltf)},
    {&readers::pinocchio, Effect::takes, kDoesNotTurn, kRun},
    {&readers::newton, Effect::takes, kDoesNotTurn, kRun},
    {&readers::ros, Effect::takes, "does not rotate the mesh, neither in RViz nor in MoveIt",
     "RViz assimp_loader.cpp:201, geometric_shapes mesh_operations.cpp:252-258"},
    {&readers::gazebo, Effect::takes, "does not rotate the mesh", "gz-common ColladaLoader.cc:718"},
    {&readers::pybullet, Effect::ignores, "does not rotate the mesh", "Bullet, collisions, run"},
};

}  // namespace

extern constinit const Rule sml1631_dae_up_axis{
    .id = "SML1631",
    .name = "dae-up-axis",
    .severity = Severity::warning,
    .summary = "A mesh has another up axis than Z: that of a COLLADA file, or Y of a glTF.",
    .why =
        "Only some readers rotate the mesh: one that looks right in one of them is rotated in another.",
    .remedy = "Export the mesh with Z up and the rotation applied.",
    .sources = "urdf-loader URDFLoader.js:667 (does not rotate); 226 of 932 public files.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1631_dae_up_axis_file
