// SPDX-License-Identifier: BSD-3-Clause
#include "base/path.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const OpenedMesh& mesh : opened_meshes(model)) {
    if (!has_other_format(mesh.reference)) continue;
    const MeshFormat found = mesh.facts.format;
    const std::string extension(path::extension(mesh.reference.filename));
    Diagnostic& diagnostic = findings.report(
        mesh.reference.span,
        "the content of this " + quoted(extension) + " file is " +
            (found == MeshFormat::unknown ? "no mesh format known here"
                                          : std::string(to_string(mesh.facts.format))));
    if (found != MeshFormat::unknown) diagnostic.help = "give the file the extension of its format";
  }
}

}  // namespace

extern constinit const Rule sml1645_mesh_format_mismatch{
    .id = "SML1645",
    .name = "mesh-format-mismatch",
    .severity = Severity::error,
    .summary = "A mesh file holds another format than its extension says.",
    .why = "Readers choose the loader by the extension, and this one cannot read the content.",
    .remedy =
        "Rename the file, or export it again; a page of a web site may have been saved in its place.",
    .sources = "MuJoCo, Bullet, Drake, urdf-loader and MARS choose by the extension.",
    .check_model = check};

}  // namespace smurf::rules
