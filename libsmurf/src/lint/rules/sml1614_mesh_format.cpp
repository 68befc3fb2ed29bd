// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1614_mesh_format_file {
namespace {

constexpr Circumstance kBobj{"bobj"};
constexpr Circumstance kOfAssimp{"read by assimp"};

constexpr std::string_view kLoaded[] = {".stl", ".obj", ".dae", ".bobj", ".gltf", ".glb",
                                        ".ply", ".vtk", ".msh", ".mesh", ".fbx",  ".3ds",
                                        ".wrl", ".cdf", ".usd", ".usda", ".usdc"};

/// Further formats that assimp reads, which DART leaves all meshes to.
constexpr std::string_view kOfAssimpOnly[] = {".ac", ".dxf", ".off", ".raw", ".x3d"};

void check(const LinkedModel& model, Findings& findings) {
  std::set<std::string> reported;
  for (const MeshReference& reference : model.meshes) {
    const std::string extension = path::to_lower(path::extension(reference.filename));
    const PathFault fault = path_fault(reference);
    // Missing files are reported by SML1604; a package may be elsewhere.
    const bool is_lost = fault == PathFault::empty || fault == PathFault::malformed_package ||
                         (fault == PathFault::missing && !reference.path.empty());
    if (reference.is_texture || is_lost) continue;
    const bool is_loaded =
        std::find(std::begin(kLoaded), std::end(kLoaded), extension) != std::end(kLoaded);
    if ((is_loaded && extension != ".bobj") || !reported.insert(extension).second) continue;
    const std::string subject = extension.empty() ? "a mesh file without extension"
                                                  : "a mesh of format " + quoted(extension);
    if (extension == ".bobj") {
      Diagnostic& diagnostic = findings.report(reference.span, subject + " is read by MARS only");
      diagnostic.when(kBobj);
      diagnostic.help("name the .obj or .stl; MARS takes the .bobj beside it");
    } else if (ranges::contains(kOfAssimpOnly, extension)) {
      findings.report(reference.span, subject + " is read by hardly any URDF reader")
          .when(kOfAssimp);
    } else {
      findings.report(reference.span, subject + " is read by no URDF reader known here");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "reads it", "MARS gui_helper_functions.cpp", when(kBobj)},
    {&readers::dart, Effect::takes, "reads it", kRun, when(kOfAssimp)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun},
    {&readers::pinocchio, Effect::takes, "reads it", "Pinocchio 4.1.0, run with .off",
     when(kOfAssimp)},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun},
};

}  // namespace

extern constinit const Rule sml1614_mesh_format{
    .id = "SML1614",
    .name = "mesh-format",
    .severity = Severity::warning,
    .summary = "A mesh has a format that hardly any URDF reader supports.",
    .why =
        "Readers choose the loader by the extension: STL, OBJ and COLLADA are common, formats of CAD programs are not.",
    .remedy = "Export an STL, OBJ or COLLADA file.",
    .sources = "Loaders of assimp, Drake, MuJoCo, Bullet, urdf-loader and MARS, read.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1614_mesh_format_file
