// SPDX-License-Identifier: BSD-3-Clause
#include "lint/habit.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

bool has_foreign_scheme(std::string_view path) {
  return path.find("://") != std::string_view::npos && !path.starts_with("package://");
}

/// One habit of an exporter, so one finding a file.
void check(const LinkedModel& model, Findings& findings) {
  Habit habit;
  for (const MeshReference& mesh : model.meshes) {
    if (!has_foreign_scheme(mesh.filename)) continue;
    habit.add(mesh.span,
              "the path " + quoted(mesh.filename) + " has a scheme that MuJoCo and MARS refuse");
  }
  habit.report("such paths", findings);
}

}  // namespace

extern constinit const Rule sml1610_mesh_uri_scheme{
    .id = "SML1610",
    .name = "mesh-uri-scheme",
    .severity = Severity::error,
    .summary = "A mesh path has a scheme that some readers do not take.",
    .why = "MuJoCo refuses `file://` and `model://`, Pinocchio every scheme but `package://` and "
           "`file://`, MARS all of them.",
    .remedy = "Write a path relative to the URDF.",
    .sources = "MuJoCo 3.14, executed; MARS misc.cpp:112-131.",
    .check_model = check};

}  // namespace smurf::rules
