// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const MeshReference& mesh : model.meshes) {
    if (mesh.exists || mesh.filename.empty()) continue;
    const bool is_package = mesh.filename.starts_with("package://");
    if (mesh.path.empty() && !is_package) continue;  // a URI of another kind is not looked up
    Diagnostic& diagnostic = findings.report(
        mesh.span, std::string(mesh.is_texture ? "texture" : "mesh") + " file not found: " +
                       quoted(mesh.filename));
    if (!mesh.path.empty()) {
      diagnostic.caret = "resolved to " + quoted(mesh.path);
    } else {
      diagnostic.caret = "in no folder above the URDF";
      diagnostic.help = "name the package's folder: `--package NAME=DIR`";
    }
    if (!mesh.is_texture) continue;
    diagnostic.severity = Severity::warning;
  }
}

}  // namespace

extern constinit const Rule sml1604_mesh_missing{
    .id = "SML1604",
    .name = "mesh-missing",
    .severity = Severity::error,
    .summary = "A mesh or texture file does not exist.",
    .why = "Bullet loses the whole robot, Drake, MuJoCo, Pinocchio and DART refuse the file or "
           "the body; urdfdom and sdformat do not look.",
    .remedy = "Correct the path (relative to the URDF), or add the file.",
    .sources = "Bullet, MuJoCo 3.14, DART 6.12 and urdfdom 3.0.1, executed.",
    .check_model = check};

}  // namespace smurf::rules
