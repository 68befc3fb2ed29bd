// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1711_mujoco_colour_leak_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const urdf::Visual* first = nullptr;
  const urdf::Visual* coloured_first = nullptr;
  std::size_t links = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const urdf::Visual* coloured = nullptr;
    for (const urdf::Visual& visual : link.visuals) {
      if (visual.material) {
        coloured = &visual;
      } else if (coloured != nullptr) {
        if (first == nullptr) {
          first = &visual;
          coloured_first = coloured;
        }
        ++links;
        return;
      }
    }
  });
  if (first == nullptr) return;
  Diagnostic& diagnostic =
      findings.report(tag_name(model, first->element),
                      "this visual has no material; MuJoCo gives it the colour of the visual "
                      "before it");
  diagnostic.label(tag_name(model, coloured_first->element), "the visual before it");
  if (links > 1) {
    diagnostic.note("this applies to " + std::to_string(links) + " links");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::changes, "keeps the colour of the visual before it",
     "MuJoCo xml_urdf.cc:291"},
};

}  // namespace

extern constinit const Rule sml1711_mujoco_colour_leak{
    .id = "SML1711",
    .name = "mujoco-colour-leak",
    .severity = Severity::info,
    .summary = "A visual without material follows one with a material in the same link.",
    .why = "Readers give a visual without material their default colour, or the one of the visual "
           "before it.",
    .remedy = "Give each visual its material.",
    .sources = "23 of 322 public URDFs.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1711_mujoco_colour_leak_file
