// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

struct Needed {
  std::string_view key;
  bool (*is_written)(const Light&);
  bool of_spots_only = false;
};

/// What has no default in MARS. Colours have one.
constexpr Needed kNeeded[] = {
    {"type", [](const Light& light) { return light.type.written; }},
    {"position", [](const Light& light) { return light.position.written; }},
    {"directional", [](const Light& light) { return light.directional.written; }},
    {"constantAttenuation", [](const Light& light) { return light.constant_attenuation.written; }},
    {"linearAttenuation", [](const Light& light) { return light.linear_attenuation.written; }},
    {"quadraticAttenuation",
     [](const Light& light) { return light.quadratic_attenuation.written; }},
    {"lookat", [](const Light& light) { return light.look_at.written; }, true},
    {"angle", [](const Light& light) { return light.angle.written; }, true},
    {"exponent", [](const Light& light) { return light.exponent.written; }, true},
};
constexpr std::int64_t kSpot = 2;

void check_light(const Light& light, Findings& findings) {
  const bool may_be_spot = !light.type || *light.type == kSpot;
  std::string missing;
  std::size_t count = 0;
  for (const Needed& needed : kNeeded) {
    if (needed.is_written(light) || (needed.of_spots_only && !may_be_spot)) continue;
    missing += (count++ == 0 ? "" : ", ") + quoted(needed.key);
  }
  if (count == 0) return;
  const Span place = light.name.written ? light.name.span : light.span;
  findings.report(place, subject("light", light) + " has no " + missing + ", which MARS reads as " +
                             (count == 1 ? "a random value" : "random values"));
}

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!world_value(file, "lights")) continue;
    for (const Light& light : file.scene.lights) check_light(light, findings);
  }
}

}  // namespace

extern constinit const Rule sml5301_light_value_missing{
    .id = "SML5301",
    .name = "light-value-missing",
    .severity = Severity::warning,
    .summary = "A light leaves out a value that has no default.",
    .why = "MARS keeps lights in a structure without default values: a number, flag or vector "
           "that the scene leaves out is whatever was in memory. Colours default to black.",
    .remedy = "Write all keys of the light; attenuations of 1, 0, 0 do not dim it.",
    .sources = "MARS LightData.h:40-65, LightData.cpp:45-71.",
    .check_scene = check};

}  // namespace smurf::rules
