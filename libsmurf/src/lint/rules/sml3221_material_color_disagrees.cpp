// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include <array>
#include <cmath>
#include <map>

#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3221_material_color_disagrees_file {
namespace {

constexpr double kVisible = 2.0 / 255;

bool differs(const Field<double>& component, double in_urdf) {
  if (component && (*component < 0 || *component > 1)) return false;  // reported as out of range
  return component && std::fabs(*component - in_urdf) > kVisible;
}

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string_view, const urdf::Material*> colours;
  for_each_material(model, [&](const urdf::Material& material) {
    if (material.name && material.rgba) colours.emplace(*material.name, &material);
  });
  for (const MaterialAnnotation& entry : model.annotations.materials) {
    if (!entry.name || !entry.diffuse_color) continue;
    const auto found = colours.find(*entry.name);
    if (found == colours.end()) continue;
    const std::array<double, 4>& rgba = *found->second->rgba;
    const Color& color = *entry.diffuse_color;
    if (!differs(color.r, rgba[0]) && !differs(color.g, rgba[1]) && !differs(color.b, rgba[2]))
      continue;
    Diagnostic& diagnostic =
        findings.report(entry.diffuse_color.span,
                        "the material " + quoted(*entry.name) + " has another colour in the URDF");
    diagnostic.label(found->second->rgba.span, "the colour of the URDF");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "shows the colour of the annotation", "MARS smurf.cpp:333-352"},
};

}  // namespace

extern constinit const Rule sml3221_material_color_disagrees{
    .id = "SML3221",
    .name = "material-color-disagrees",
    .severity = Severity::info,
    .summary = "A material has another colour in the annotation than in the URDF.",
    .why = "Readers of the URDF alone show the colour of the URDF.",
    .remedy = "Make the two agree, if the robot should look the same everywhere.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3221_material_color_disagrees_file
