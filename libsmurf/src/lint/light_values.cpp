// SPDX-License-Identifier: BSD-3-Clause
#include "lint/light_values.hpp"

#include <algorithm>
#include <vector>

#include "ast/keys.hpp"
#include "base/text/suggest.hpp"
#include "lint/queries.hpp"

namespace smurf {
namespace {

struct Needed {
  std::string_view key;
  bool (*is_written)(const Light&);
  bool of_spots_only = false;
};

/// The keys without a default in MARS. Colours have defaults.
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

/// Whether an unknown key is a misspelling of this key; then it is reported elsewhere.
bool is_misspelt(yaml::View mapping, std::string_view key) {
  std::vector<std::string_view> known;
  for (const Needed& needed : kNeeded) known.push_back(needed.key);
  return std::any_of(mapping.begin(), mapping.end(),
                     [&](yaml::View value) { return nearest(value.key(), known) == key; });
}

}  // namespace

void report_incomplete_light(const Light& light, yaml::View mapping, Findings& findings) {
  const bool may_be_spot = !light.type || *light.type == kSpot;
  std::string missing;
  std::string_view first;
  std::size_t count = 0;
  for (const Needed& needed : kNeeded) {
    if (needed.is_written(light) || (needed.of_spots_only && !may_be_spot)) continue;
    if (!mapping || is_misspelt(mapping, needed.key)) continue;
    if (count == 0) first = needed.key;
    missing += (count++ == 0 ? "" : ", ") + quoted(needed.key);
  }
  if (count == 0) return;
  const Span place = light.name.written ? light.name.span : light.span;
  findings
      .report(place, subject("light", light) + " has no " + missing + ", which MARS reads as " +
                         (count == 1 ? "a random value" : "random values"))
      .label(place_to_add(mapping, first), "add it after this key");
}

}  // namespace smurf
