// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1645_mesh_format_mismatch_file {
namespace {

constexpr Circumstance kObj{".obj"};

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
    if (extension == ".obj") diagnostic.when(kObj);
    if (found != MeshFormat::unknown) diagnostic.help("give the file the extension of its format");
  }
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::loses, "builds the link without the shape", kRun},
    {&readers::drake, Effect::loses,
     "opens the mesh of a visual only to draw it, and draws nothing", kRun, at("visual")},
    {&readers::drake, Effect::refuses, "refuses the file", kRun, at("collision")},
    ros_without_mesh(),
    gazebo_without_mesh(),
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::dart, Effect::loses, "finds no triangle in it", kRun, when(kObj)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun},
    {&readers::phobos, Effect::loses, "keeps a mesh that it cannot open", kRun},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun},
};

}  // namespace

extern constinit const Rule sml1645_mesh_format_mismatch{
    .id = "SML1645",
    .name = "mesh-format-mismatch",
    .severity = Severity::error,
    .summary = "The content of a mesh file does not match its extension.",
    .why = "Readers choose the loader by the extension, and this one cannot read the content.",
    .remedy =
        "Rename the file, or export it again; perhaps a web page was saved instead of the file.",
    .sources = "MuJoCo, Bullet, Drake, urdf-loader and MARS choose by the extension.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1645_mesh_format_mismatch_file
