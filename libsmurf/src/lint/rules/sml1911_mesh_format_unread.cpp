// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/path.hpp"
#include "base/ranges.hpp"
#include "base/readers.hpp"
#include "base/words.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1911_mesh_format_unread_file {
namespace {

/// "dae" for the file name "base.DAE", "other-step" for a format that no fact is about, and
/// "stl#mixed-case" for "base.Stl"; empty when there is none.
std::string format_of(std::string_view filename) {
  constexpr std::string_view kKnown[] = {"obj", "stl", "msh",  "dae", "vtk",
                                         "cdf", "glb", "gltf", "bobj"};
  constexpr std::string_view kOfMujoco[] = {"obj", "stl", "msh"};
  const std::string_view written = path::extension(filename);
  if (written.size() < 2) return trimmed(filename).empty() ? "" : "no-format";
  const std::string extension(written.substr(1)), lower = path::to_lower(extension);
  if (!ranges::contains(kKnown, lower)) return "other-" + lower;
  const bool is_upper = ranges::any_of(extension, [](char c) { return c >= 'a' && c <= 'z'; });
  const bool is_mixed = extension != lower && is_upper;
  return is_mixed && ranges::contains(kOfMujoco, lower) ? lower + "#mixed-case" : lower;
}

std::string message(const std::string& what, std::string_view format) {
  if (format == "no-format") return "the mesh of a " + what + " has no extension";
  if (format.starts_with("other-")) format.remove_prefix(format.find('-') + 1);
  return "the mesh of a " + what + " is a ." + std::string(format.substr(0, format.find('#'))) +
         " file";
}

void check(const LinkedModel& model, Findings& findings) {
  // One finding per format, because a robot has dozens of meshes.
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
    Diagnostic& diagnostic = findings.report(places.front(), message(what, format));
    diagnostic.construct = format;
    if (places.size() > 1) {
      diagnostic.note("the same applies to those of " + std::to_string(places.size() - 1) +
                      " more " + what + (places.size() > 2 ? "s" : ""));
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "reads it", "Bullet UrdfFindMeshFile.h", "#obj"},
    {&readers::pybullet, Effect::takes, "reads it", "Bullet UrdfFindMeshFile.h", "#dae"},
    {&readers::pybullet, Effect::takes, "reads it", "Bullet UrdfFindMeshFile.h", "#stl"},
    {&readers::pybullet, Effect::takes, "reads it", "Bullet UrdfFindMeshFile.h", "#vtk"},
    {&readers::pybullet, Effect::takes, "reads it", "Bullet UrdfFindMeshFile.h", "#cdf"},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot",
     "Bullet UrdfFindMeshFile.h, run"},
    {&readers::ros, Effect::loses, "has no loader for it: RViz and MoveIt show the link without it",
     "assimp 5.2", "#bobj"},
    {&readers::gazebo, Effect::loses, "has no loader for it", "sdformat stores it unchecked",
     "#bobj"},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun, "#bobj"},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun, "#glb"},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun, "#msh"},
    {&readers::mujoco, Effect::refuses,
     "recognises an extension only when it is all lower case or all upper case", kRun,
     "#mixed-case"},
    {&readers::mujoco, Effect::takes, "reads it", kRun, "#obj"},
    {&readers::mujoco, Effect::takes, "reads it", kRun, "#stl"},
    {&readers::mujoco, Effect::takes, "reads it", kRun, "#msh"},
    {&readers::mujoco, Effect::refuses, "has no decoder for it, and refuses the model", kRun},
    {&readers::drake, Effect::takes, "reads it", "Drake make_convex_hull_mesh_impl.cc:279-291",
     "#obj"},
    {&readers::drake, Effect::takes, "reads it", "Drake make_convex_hull_mesh_impl.cc:279-291",
     "#vtk"},
    {&readers::drake, Effect::takes, "reads it", "Drake make_convex_hull_mesh_impl.cc:279-291",
     "#gltf"},
    {&readers::drake, Effect::refuses, "throws when it needs the hull of the mesh",
     "Drake make_convex_hull_mesh_impl.cc:279-291", "/collision/"},
};

}  // namespace

extern constinit const Rule sml1911_mesh_format_unread{
    .id = "SML1911",
    .name = "mesh-format-unread",
    .severity = Severity::error,
    .summary = "A mesh is in a format that a target does not read.",
    .why = "URDF does not say which mesh formats a reader must support.",
    .remedy = "Convert the mesh; .obj is read by all of them.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1911_mesh_format_unread_file
