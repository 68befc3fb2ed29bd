// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/counted.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1641_external_texture_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const OpenedMesh& mesh : opened_meshes(model)) {
    std::vector<const MeshDependency*> lost;
    for (const MeshDependency& one : mesh.file.lost) {
      if (one.kind != MeshDependency::Kind::buffer) lost.push_back(&one);  // SML1644
    }
    if (lost.empty()) continue;
    const MeshDependency& first = *lost.front();
    const bool is_texture = first.kind == MeshDependency::Kind::texture;
    Diagnostic& diagnostic = findings.report(
        mesh.reference.span,
        std::string("the mesh names the ") + (is_texture ? "texture " : "material library ") +
            quoted(first.filename) +
            (first.is_denied ? ", which lies outside of the project" : ", which does not exist"));
    if (first.is_denied) diagnostic.help("read it with `--allow-outside`");
    if (!is_texture) diagnostic.severity = Severity::info;
    if (lost.size() > 1) {
      diagnostic.note(counted(lost.size() - 1, "other file") + " that it names " +
                      (lost.size() == 2 ? "is" : "are") + " missing, too");
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
    .sources =
        "OBJ (mtllib, map_Kd), COLLADA (init_from) and glTF (images) by their specifications.",
    .check_model = check,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1641_external_texture_missing_file
