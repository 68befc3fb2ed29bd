// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4115_color_without_alpha_file {
namespace {

bool lacks_alpha(const Field<Color>& color) {
  return color && !color->a.written && (color->r.written || color->g.written || color->b.written);
}

void check(const LinkedModel& model, Findings& findings) {
  for (const MaterialAnnotation& material : model.annotations.materials) {
    const std::pair<std::string_view, const Field<Color>*> colors[] = {
        {"ambientColor", &material.ambient_color},
        {"diffuseColor", &material.diffuse_color},
        {"specularColor", &material.specular_color},
        {"emissionColor", &material.emission_color}};
    std::string keys;
    Span place;
    for (const auto& [key, color] : colors) {
      if (!lacks_alpha(*color)) continue;
      if (keys.empty()) place = mapping_of(model, material).find(key).key_span();
      keys += (keys.empty() ? "" : ", ") + quoted(key);
    }
    if (keys.empty()) continue;
    findings
        .report(place, subject("material", material) + " has no `a` in " + keys +
                           ": MARS uses 0, Phobos 1")
        .help("add `a: 1.0`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "reads every absent component as 0, alpha too, so the material may be invisible",
     "mars_utils Color.cpp:28-34, run"},
    {&readers::mars2, Effect::takes, "uses 1", "envire_smurf_loader Model.cpp:296-311"},
    {&readers::phobos, Effect::takes, "uses 1", "Phobos, read"},
};

}  // namespace

extern constinit const Rule sml4115_color_without_alpha{
    .id = "SML4115",
    .name = "color-without-alpha",
    .severity = Severity::warning,
    .summary = "A colour has no alpha, which is 0 in MARS and 1 elsewhere.",
    .remedy = "Add `a: 1.0`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4115_color_without_alpha_file
