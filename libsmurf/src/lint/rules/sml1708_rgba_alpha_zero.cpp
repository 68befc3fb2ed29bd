// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules::sml1708_rgba_alpha_zero_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_material(model, [&](const urdf::Material& material) {
    if (!material.rgba || (*material.rgba)[3] != 0) return;
    findings.report(material.rgba.span, "the fourth component is 0: the material is invisible");
  });
}

}  // namespace

extern constinit const Rule sml1708_rgba_alpha_zero{
    .id = "SML1708",
    .name = "rgba-alpha-zero",
    .severity = Severity::warning,
    .summary = "A colour has an alpha of 0.",
    .why = "The shape is not drawn; 1 is opaque.",
    .remedy = "Write 1 for an opaque material; delete the visual if it is meant to be invisible.",
    .sources = "URDF specification.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1708_rgba_alpha_zero_file
