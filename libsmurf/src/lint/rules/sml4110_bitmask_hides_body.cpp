// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/text/counted.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4110_bitmask_hides_body_file {
namespace {

constexpr Circumstance kRays{"rays"};

constexpr std::int64_t kSeenByRays = 32768;
constexpr std::int64_t kDefault = 65535;

bool has_ray_sensor(const LinkedModel& model) {
  const auto& sensors = model.annotations.sensors;
  return std::any_of(sensors.begin(), sensors.end(), [](const Sensor& sensor) {
    return sensor.type && (*sensor.type == "RaySensor" || *sensor.type == "RotatingRaySensor");
  });
}

void check(const LinkedModel& model, Findings& findings) {
  std::vector<const CollisionAnnotation*> hidden;
  for (const CollisionAnnotation& entry : model.annotations.collisions) {
    if (!entry.bitmask) continue;
    if (*entry.bitmask == 0) {
      findings
          .report(entry.bitmask.span,
                  subject("collision", entry) + " collides with nothing: its bitmask is 0")
          .severity = Severity::warning;
    } else if ((*entry.bitmask & kDefault) == 0) {
      findings
          .report(
              entry.bitmask.span,
              subject("collision", entry) +
                  " collides with nothing that has the default mask: none of the bits 0 to 15 is "
                  "set")
          .severity = Severity::warning;
    } else if ((*entry.bitmask & kSeenByRays) == 0) {
      hidden.push_back(&entry);
    }
  }
  if (hidden.empty()) return;
  // Models give such masks to all collisions or to none.
  const CollisionAnnotation& first = *hidden.front();
  const std::size_t others = hidden.size() - 1;
  std::string who = subject("collision", first);
  if (others > 0) who += " and " + counted(others, "other");
  Diagnostic& diagnostic = findings.report(first.bitmask.span, "ray sensors of MARS do not see " +
                                                                   who + ": bit 15 is not set");
  diagnostic.when(kRays);
  diagnostic.help("set bit 15: `bitmask: " + std::to_string(*first.bitmask | kSeenByRays) + "`");
  // A robot with ray sensors is rarely meant to be invisible to them.
  if (has_ray_sensor(model)) diagnostic.severity = Severity::warning;
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "its ray sensors see only bodies with bit 15 (32768)",
     "MARS NodePhysics.cpp:1389-1390, 1449", when(kRays)},
};

}  // namespace

extern constinit const Rule sml4110_bitmask_hides_body{
    .id = "SML4110",
    .name = "bitmask-hides-body",
    .severity = Severity::info,
    .summary = "A bitmask excludes a collision from contacts or from ray sensors.",
    .why =
        "Two objects collide when their masks share a bit, so a mask of 0 collides with nothing.",
    .remedy = "Add 32768 to the mask when lasers and sonars are to see the body.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4110_bitmask_hides_body_file
