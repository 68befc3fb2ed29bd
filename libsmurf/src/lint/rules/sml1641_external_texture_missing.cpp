// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const OpenedMesh& mesh : opened_meshes(model)) {
    if (mesh.file.lost.empty()) continue;
    const MeshDependency& first = mesh.file.lost.front();
    Diagnostic& diagnostic = findings.report(
        mesh.reference.span,
        std::string("the mesh names the ") + (first.is_texture ? "texture " : "material library ") +
            quoted(first.filename) +
            (first.is_denied ? ", which lies outside of the project" : ", which is not there"));
    if (first.is_denied) diagnostic.help("read it with `--allow-outside`");
    if (!first.is_texture) diagnostic.severity = Severity::info;
    if (mesh.file.lost.size() > 1) {
      diagnostic.note(std::to_string(mesh.file.lost.size() - 1) +
                      " other files that it names are missing, too");
    }
  }
}

}  // namespace

extern constinit const Rule sml1641_external_texture_missing{
    .id = "SML1641",
    .name = "external-texture-missing",
    .severity = Severity::warning,
    .summary = "A mesh names a texture or a material library that does not exist.",
    .why = "The mesh is drawn grey.",
    .remedy = "Add the file beside the mesh, or delete the reference from it.",
    .sources = "OBJ (mtllib, map_Kd) and COLLADA (init_from) by their specifications.",
    .check_model = check};

}  // namespace smurf::rules
