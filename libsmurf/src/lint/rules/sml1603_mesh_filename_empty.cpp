// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1603_mesh_filename_empty_file {
namespace {

constexpr Circumstance kEmpty{"empty"};

void check(const LinkedModel& model, Findings& findings) {
  for (const PathUses& path : paths_with(model, PathFault::empty)) {
    for (const MeshReference* reference : path.references) {
      const bool is_texture = reference->is_texture;
      const bool is_blank = !reference->filename.empty();
      Diagnostic& diagnostic =
          findings.report(reference->span, std::string("the ") + (is_texture ? "texture" : "mesh") +
                                               " names no file");
      if (!is_blank) diagnostic.when(kEmpty);
      // Exporters write it into every material.
      if (is_texture) diagnostic.severity = Severity::info;
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::pinocchio, Effect::refuses, "does not find the mesh, and refuses the shapes", kRun,
     at("mesh")},
    {&readers::urdfdom, Effect::takes, "needs no texture", kRun, at("texture")},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", kRun, at("mesh")},
    urdfdom_drops_shapes(),
    {&readers::drake, Effect::takes, "needs no texture", kRun, at("texture")},
    {&readers::drake, Effect::loses, "leaves out the shape", kRun, at("visual").when(kEmpty)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
    {&readers::gazebo, Effect::takes, "needs no texture", kRun, at("texture")},
    {&readers::gazebo, Effect::refuses, "refuses the file", kRun},
    {&readers::mujoco, Effect::takes, "needs no texture", kRun, at("texture")},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun,
     at("mesh")},
    {&readers::phobos, Effect::loses, "keeps a mesh without a file", kRun},
    {&readers::newton, Effect::takes, "needs no texture", kRun, at("texture")},
    {&readers::newton, Effect::refuses, "opens the folder, and refuses the file", kRun,
     when(kEmpty)},
    newton_without_mesh(),
    {&readers::isaac, Effect::takes, "needs no texture", kRun, at("texture")},
    isaac_without_mesh(),
};

}  // namespace

extern constinit const Rule sml1603_mesh_filename_empty{
    .id = "SML1603",
    .name = "mesh-filename-empty",
    .severity = Severity::error,
    .summary = "The file name of a mesh or texture is empty.",
    .remedy = "Name the file, or delete the element around it.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1603_mesh_filename_empty_file
