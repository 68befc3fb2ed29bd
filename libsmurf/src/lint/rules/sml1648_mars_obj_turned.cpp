// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1648_mars_obj_turned_file {
namespace {

/// Phobos 2 writes meshes for MARS alone, y up, as mars_obj/NAME.mars.obj.
bool is_for_mars(std::string_view path) {
  return path.ends_with(".mars.obj") || path.find("mars_obj/") != std::string_view::npos;
}

void check(const LinkedModel& model, Findings& findings) {
  std::vector<const MeshReference*> turned;
  for (const MeshReference& reference : model.meshes) {
    if (reference.is_texture || !reference.mars_exists) continue;
    if (path::to_lower(path::extension(reference.mars_path)) != ".obj") continue;
    if (!is_for_mars(reference.filename)) turned.push_back(&reference);
  }
  report_turned(turned, "MARS turns this OBJ by 90 degrees about x; URDF readers do not",
                "OBJ files", findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "turns the mesh of visuals and collisions by 90 degrees about x: y becomes z",
     "MARS gui_helper_functions.cpp:384; OpenSceneGraph 3.6.5, run"},
};

}  // namespace

extern constinit const Rule sml1648_mars_obj_turned{
    .id = "SML1648",
    .name = "mars-obj-turned",
    .severity = Severity::warning,
    .summary = "A mesh of a SMURF model is an OBJ file without a .bobj beside it.",
    .why = "In the simulation, the mesh is turned relative to all other programs.",
    .remedy = "Add .bobj files. A mesh with the y axis up, which only MARS reads, is called "
              "NAME.mars.obj, as in Phobos.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1648_mars_obj_turned_file
