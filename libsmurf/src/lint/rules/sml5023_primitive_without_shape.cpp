// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/keys.hpp"
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/suggest.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5023_primitive_without_shape_file {
namespace {

constexpr Circumstance kSize{"size"};

constexpr std::string_view kShapes[] = {"plane", "box", "sphere", "cylinder", "capsule"};

void report_shape(yaml::View shape, Findings& findings) {
  Diagnostic& diagnostic =
      findings.report(shape.place(), quoted(shape.text()) + " is not a shape of a primitive");
  diagnostic.help("shapes are plane, box, sphere, cylinder and capsule");
  if (const auto near = only_nearest(shape.text(), kShapes)) {
    diagnostic.help("did you mean " + quoted(*near) + "?");
    diagnostic.fixes.push_back(
        {Applicability::unsafe, {{within_quotes(shape), std::string(*near)}}});
  }
}

/// The number of components of `extend` that set the size of a shape, x first.
std::size_t size_components(std::string_view shape) {
  if (shape == "box") return 3;
  if (shape == "plane" || shape == "cylinder" || shape == "capsule") return 2;
  return 1;
}

void check_size(yaml::View extend, std::string_view shape, Findings& findings) {
  constexpr std::string_view kNames[] = {"x", "y", "z"};
  if (!extend || !extend.is_mapping()) return;
  for (std::size_t i = 0; i < size_components(shape); ++i) {
    const yaml::View size = extend.find(kNames[i]);
    const std::optional<double> number = size ? size.number() : 0;
    if (!number || *number > 0) continue;  // another rule reports values that are not numbers
    findings
        .report(size ? size.span() : extend.span(), "`extend` gives the " + std::string(shape) +
                                                        " the size " + format_number(*number) +
                                                        " along " + std::string(kNames[i]))
        .when(kSize);
    return;
  }
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    if (entity_type(entity) != "primitive") return;
    const yaml::View keys = mapping_of(file, entity);
    const yaml::View geometry = keys.find("geometry");
    if (geometry && !geometry.is_null() && !geometry.is_mapping()) return;  // a wrong type
    const yaml::View shape =
        geometry && geometry.is_mapping() ? geometry.find("type") : yaml::View();
    if (!shape || shape.is_null()) {
      if (!keys.find("physicmode")) {
        findings.report(place_of(entity), title(entity) + " is a primitive without a shape");
      }
      return;
    }
    const bool is_known =
        std::find(std::begin(kShapes), std::end(kShapes), shape.text()) != std::end(kShapes);
    if (!shape.is_scalar() || !is_known) return report_shape(shape, findings);
    check_size(keys.find("extend"), shape.text(), findings);
    const bool has_preset = shape.text() != "cylinder" && shape.text() != "capsule";
    if (has_preset || (keys.find("extend") && keys.find("physicmode"))) return;
    const std::string name(shape.text());
    Diagnostic& diagnostic = findings.report(
        shape.span(), "MARS makes a " + name + " only from `physicmode` and `extend`");
    diagnostic.help("add `physicmode: " + name + ", extend: {x: RADIUS, y: LENGTH, z: 0}`");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "makes no node of such a size", kRun, when(kSize)},
    {&readers::mars, Effect::crashes,
     "ends with an uncaught exception: it reads the shape from `geometry: {type: ...}`, and has "
     "sizes for plane, box and sphere only",
     "MARS primitives.cpp:115-153 and 212, run"},
};

}  // namespace

extern constinit const Rule sml5023_primitive_without_shape{
    .id = "SML5023",
    .name = "primitive-without-shape",
    .severity = Severity::error,
    .summary = "An entity of type primitive has no shape, an unknown one, or one without a size.",
    .remedy = "Write `geometry: {type: box}` (plane, sphere); give a cylinder or capsule its "
              "`physicmode` and its `extend`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5023_primitive_without_shape_file
