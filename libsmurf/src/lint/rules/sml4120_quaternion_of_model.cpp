// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <initializer_list>
#include <string>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4120_quaternion_of_model_file {
namespace {

template <class Entries>
void check_entries(const LinkedModel& model, const Entries& entries, std::string_view what,
                   std::initializer_list<std::string_view> keys, Findings& findings) {
  constexpr double kTolerance = 1e-3;
  constexpr double kShortest = 1e-6;
  for (const auto& entry : entries) {
    const yaml::View mapping = mapping_of(model, entry);
    for (const std::string_view key : keys) {
      const yaml::View value = mapping ? mapping.find(key) : yaml::View();
      const auto length = quaternion_length(value);
      if (!length || std::fabs(*length - 1) <= kTolerance) continue;
      Diagnostic& diagnostic = findings.report(
          value.span(), quoted(key) + " of " + subject(what, entry) +
                            " is a quaternion of length " + format_rounded(*length));
      if (*length < kShortest) {
        diagnostic.severity = Severity::error;
        diagnostic.note("it defines no rotation");
        diagnostic.help("write w: 1, x: 0, y: 0, z: 0 for no rotation, or delete the key");
      }
    }
  }
}

void check(const LinkedModel& model, Findings& findings) {
  const Annotations& all = model.annotations;
  check_entries(model, all.sensors, "sensor",
                {"orientation_offset", "rotation_offset", "orientation"}, findings);
  check_entries(model, all.nodes, "node", {"rotation", "visualrotation"}, findings);
  check_entries(model, all.links, "link entry", {"rotation", "visualrotation"}, findings);
  check_entries(model, all.visuals, "visual entry", {"rotation", "visualrotation"}, findings);
  check_entries(model, all.collisions, "collision entry", {"rotation", "visualrotation"}, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "does not normalise the quaternion, so it stretches or shrinks the vectors that it rotates; "
     "ODE ends the program when the length is zero",
     "MARS SimEntity.cpp:416-434, NodePhysics.cpp:526-597, run"},
};

}  // namespace

extern constinit const Rule sml4120_quaternion_of_model{
    .id = "SML4120",
    .name = "quaternion-of-model",
    .severity = Severity::warning,
    .summary = "An orientation in an annotation is a quaternion whose length is not one.",
    .remedy = "Divide the four numbers by the length of the quaternion; the identity rotation is "
              "w: 1, x: 0, y: 0, z: 0.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4120_quaternion_of_model_file
