// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1705_material_redefined_file {
namespace {

constexpr Circumstance kRounding{"rounding"};

/// True when both are given and differ.
template <class T>
bool is_other(const Field<T>& here, const Field<T>& first) {
  return here && (!first || *here != *first);
}

/// Drake treats colours that are this close as equal, detail_urdf_geometry.cc:76-80.
bool is_rounding(const urdf::Material& here, const urdf::Material& first) {
  constexpr double kClosest = 1e-10;
  if (!here.rgba || !first.rgba || is_other(here.texture, first.texture)) return false;
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double step = (*here.rgba)[i] - (*first.rgba)[i];
    square += step * step;
  }
  return square <= kClosest * kClosest;
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::map<std::string_view, const urdf::Material*> first_by_name;
  std::set<std::string_view> reported;
  for_each_material(model, [&](const urdf::Material& material) {
    if (!material.name || material.name->empty()) return;
    if (!material.rgba && !material.texture) return;
    const auto [known, is_new] = first_by_name.emplace(*material.name, &material);
    const urdf::Material& first = *known->second;
    if (is_new) return;
    const bool is_color = is_other(material.rgba, first.rgba);
    const bool is_changed = is_color || is_other(material.texture, first.texture);
    // Duplicate materials at robot level are reported as SML1704.
    const bool is_global =
        xml::View(model.robot->document, material.element).parent().name() == "robot";
    if (!is_changed || is_global || !reported.insert(*material.name).second) return;
    Diagnostic& diagnostic =
        findings.report(is_color ? material.rgba.span : material.texture.span,
                        "the material " + quoted(*material.name) + " has another " +
                            (is_color ? "colour" : "texture") + " here");
    const Span before = is_color ? first.rgba.span : first.texture.span;
    if (before.empty()) {
      diagnostic.label(tag_name(model, first.element), "none here");
    } else {
      diagnostic.label(before, "the first one");
    }
    if (is_rounding(material, first)) diagnostic.when(kRounding);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "uses the first for both", kRun},
    {&readers::pybullet, Effect::takes, "gives each visual its own", kRun},
    {&readers::mujoco, Effect::takes, "gives each visual its own", kRun},
    {&readers::drake, Effect::takes, "treats colours that differ by less than 1e-10 as equal", kRun,
     when(kRounding)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1705_material_redefined{
    .id = "SML1705",
    .name = "material-redefined",
    .severity = Severity::warning,
    .summary = "A material is defined twice, with different colours or textures.",
    .remedy = "Name the second material differently, or write the colour once.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1705_material_redefined_file
