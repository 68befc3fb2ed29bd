// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_material(model, [&](const urdf::Material& material) {
    if (!material.rgba) return;
    for (const double component : *material.rgba) {
      if (component >= 0 && component <= 1) continue;
      Diagnostic& diagnostic =
          findings.report(material.rgba.span, "the colour component " + format_number(component) +
                                                  " is not between 0 and 1");
      if (component > 1) diagnostic.help = "divide 0-255 values by 255";
      return;
    }
  });
}

}  // namespace

extern constinit const Rule sml1707_rgba_range{
    .id = "SML1707",
    .name = "rgba-range",
    .severity = Severity::error,
    .summary = "A colour component lies outside 0 to 1.",
    .why = "urdfdom drops the material (components are checked, 255 is none), MuJoCo clips it.",
    .remedy = "Divide 0-255 values by 255.",
    .sources = "urdfdom 3.0.1 link.cpp:86-94 and MuJoCo 3.14, executed.",
    .check_model = check};

}  // namespace smurf::rules
