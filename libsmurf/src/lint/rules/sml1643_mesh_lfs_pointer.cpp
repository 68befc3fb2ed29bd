// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1643_mesh_lfs_pointer_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  Diagnostic* diagnostic = report_meshes(
      model, [](const OpenedMesh& mesh) { return mesh.facts.format == MeshFormat::lfs_pointer; },
      "", "", findings);
  if (diagnostic == nullptr) return;
  // The same text for all robots of a repository, whatever their numbers of meshes.
  diagnostic->message = "mesh files are Git LFS pointers, not meshes";
  diagnostic->help("run `git lfs pull`");
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::loses, "builds the link without the shape", kRun},
    {&readers::drake, Effect::loses,
     "opens the mesh of a visual only to draw it, and draws nothing", kRun, at("visual")},
    ros_without_mesh(),
    gazebo_without_mesh(),
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::phobos, Effect::loses, "keeps a mesh that it cannot open", kRun},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun},
};

}  // namespace

extern constinit const Rule sml1643_mesh_lfs_pointer{
    .id = "SML1643",
    .name = "mesh-lfs-pointer",
    .severity = Severity::error,
    .summary = "A mesh file is a Git LFS pointer instead of its content.",
    .why =
        "The file exists, but contains three lines of text: every reader fails to load it without naming the cause.",
    .remedy = "Run `git lfs pull`.",
    .sources = "Git LFS pointer format; pollen-robotics/reachy_mini issue 760.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1643_mesh_lfs_pointer_file
