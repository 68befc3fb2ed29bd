// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5306_gravity_implausible_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.scene.physics || !world_value(file, "physics")) continue;
    const Field<Vector3>& gravity = file.scene.physics->gravity;
    if (!gravity) continue;
    const auto& [x, y, z] = *gravity;
    const double strength = hypotenuse(x, y, z);
    const yaml::View keys(*file.document, file.scene.physics->node);
    const yaml::View up = keys.find("gravity").find("z");
    // Jupiter pulls with 25 m/s^2; centimetres and feet give more.
    if (strength > findings.tolerance()) {
      findings.report(gravity.span, "gravity is " + format_rounded(strength) +
                                        " m/s^2; that of the earth is 9.81");
    } else if (z > 0 && z > 0.5 * strength) {
      Diagnostic& diagnostic = findings.report(up.span(), "gravity pulls upward");
      diagnostic.help("did you mean " + format_number(-z) + "?");
      diagnostic.fixes.push_back({Applicability::unsafe, {{up.span(), format_number(-z)}}});
    } else if (strength == 0 && !up && !keys.find("gravity").find("Z")) {
      findings.report(gravity.span, "there is no gravity: `z` is missing and is read as 0");
    } else if (strength > 0 && z == 0) {
      findings.report(gravity.span, "gravity pulls sideways")
          .help("z points upward in MARS, so gravity is `z: " + format_number(-strength) + "`");
    }
  }
}

}  // namespace

extern constinit const Rule sml5306_gravity_implausible{
    .id = "SML5306",
    .name = "gravity-implausible",
    .severity = Severity::warning,
    .summary = "Gravity pulls upward or sideways, is zero, or is stronger than on any planet.",
    .why = "In SMURF scenes z points up and gravity is an acceleration vector in m/s^2: with a "
           "positive z, everything falls upward.",
    .remedy = "Write {x: 0, y: 0, z: -9.81}.",
    .sources = "MARS SMURFLoader.cpp:455-462.",
    .check_scene = check,
    .tolerance = {.value = 30, .unit = "m/s^2", .meaning = "the strongest gravity"}};

}  // namespace smurf::rules::sml5306_gravity_implausible_file
