// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/path.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

/// "dae" for the file name "base.DAE"; empty when there is none.
std::string format_of(std::string_view filename) {
  std::string extension = path::to_lower(path::extension(filename));
  return extension.empty() ? extension : extension.substr(1);
}

void check(const LinkedModel& model, Findings& findings) {
  // A robot has one format and dozens of meshes: one finding for the format.
  std::map<std::pair<GeometryRole, std::string>, std::vector<Span>> uses;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.mesh() == nullptr || !use.mesh()->filename) return;
    std::string format = format_of(*use.mesh()->filename);
    if (format.empty()) return;
    uses[{use.role, std::move(format)}].push_back(use.mesh()->filename.span);
  });
  for (const auto& [key, places] : uses) {
    const auto& [role, format] = key;
    const std::string what = std::string(to_string(role));
    Diagnostic& diagnostic =
        findings.report(places.front(), "the mesh of a " + what + " is a ." + format + " file");
    diagnostic.construct = format;
    if (places.size() > 1) {
      diagnostic.notes.push_back("so are those of " + std::to_string(places.size() - 1) + " more " +
                                 what + (places.size() > 2 ? "s" : ""));
    }
  }
}

}  // namespace

extern constinit const Rule sml1911_mesh_format_unread{
    .id = "SML1911",
    .name = "mesh-format-unread",
    .severity = Severity::error,
    .summary = "A mesh is in a format that a target does not read.",
    .why = "URDF names no format. MuJoCo reads .obj, .stl and .msh, Drake .obj, .gltf and .vtk for "
           "collisions, Bullet .obj, .dae, .stl, .vtk and .cdf; only MARS and Phobos know .bobj.",
    .remedy = "Convert the mesh; .obj is read by all of them.",
    .sources = "MuJoCo 3.14, DART 6.12.1 and Bullet UrdfFindMeshFile.h, executed; Drake "
               "make_convex_hull_mesh_impl.cc:279-291.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
