// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const PathUses& path : paths_with(model, PathFault::empty)) {
    for (const MeshReference* reference : path.references) {
      const bool is_texture = reference->is_texture;
      findings.report(reference->span,
                      std::string("the ") + (is_texture ? "texture" : "mesh") + " names no file");
    }
  }
}

}  // namespace

extern constinit const Rule sml1603_mesh_filename_empty{
    .id = "SML1603",
    .name = "mesh-filename-empty",
    .severity = Severity::error,
    .summary = "The file name of a mesh or texture is empty.",
    .why = "urdfdom drops the rest of the link silently, sdformat and MuJoCo refuse the file.",
    .remedy = "Name the file, or delete the element around it.",
    .sources = "urdfdom 3.0.1, sdformat 12.3 and MuJoCo 3.14, executed.",
    .check_model = check};

}  // namespace smurf::rules
