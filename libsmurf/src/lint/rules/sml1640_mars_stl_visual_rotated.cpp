// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1640_mars_stl_visual_rotated_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::vector<const MeshReference*> turned;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.role != GeometryRole::visual || use.mesh() == nullptr) return;
    const MeshReference* reference = find_reference(model, *use.mesh());
    if (reference == nullptr || !reference->mars_exists) return;
    const std::string_view extension = path::extension(reference->mars_path);
    if (extension == ".stl" || extension == ".STL") turned.push_back(reference);
  });
  report_turned(turned, "MARS turns this STL by -90 degrees about x, as it is a visual",
                "STL files", findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "rotates the STL mesh of a visual by -90 degrees about x, but not that of a collision",
     "MARS smurf.cpp:1129-1136"},
};

}  // namespace

extern constinit const Rule sml1640_mars_stl_visual_rotated{
    .id = "SML1640",
    .name = "mars-stl-visual-rotated",
    .severity = Severity::warning,
    .summary = "A visual of a SMURF model is an STL file without a .bobj beside it.",
    .why = "The visual does not match the collision.",
    .remedy = "Add .bobj files.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1640_mars_stl_visual_rotated_file
