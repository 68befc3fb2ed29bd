// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5307_fog_range_file {
namespace {

std::optional<double> number_at(yaml::View mapping, std::string_view key) {
  const yaml::View value = mapping.find(key);
  return value ? value.number() : std::nullopt;
}

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    const yaml::View environment = world_value(file, "environment");
    const yaml::View fog =
        environment && environment.is_mapping() ? environment.find("fog") : yaml::View();
    if (!fog || !fog.is_mapping()) continue;
    const auto start = number_at(fog, "start");
    const auto end = number_at(fog, "end");
    if (!start || !end || *start < *end) continue;
    Diagnostic& diagnostic = findings.report(
        fog.find("end").span(), "the fog is full at " + format_number(*end) + " m, but begins at " +
                                    format_number(*start) + " m");
    diagnostic.label(fog.find("start").span(), "it begins here");
  }
}

}  // namespace

extern constinit const Rule sml5307_fog_range{
    .id = "SML5307",
    .name = "fog-range",
    .severity = Severity::warning,
    .summary = "Fog ends before it begins.",
    .why = "The renderer interpolates between the two distances; when they are equal or swapped "
           "it divides by zero or shows the fog inside out.",
    .remedy = "Make `end` greater than `start`; both are metres.",
    .sources = "MARS SMURFLoader.cpp:516-535; OpenGL 2.1 specification, section 3.10.",
    .check_scene = check};

}  // namespace smurf::rules::sml5307_fog_range_file
