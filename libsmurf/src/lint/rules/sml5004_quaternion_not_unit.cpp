// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5004_quaternion_not_unit_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (entity.rotation.form != RotationForm::quaternion) return;
    const auto& [w, x, y, z] = entity.rotation.values;
    const double length = norm({w, x, y, z});
    // Four digits, as the documentation writes quaternions, are off by less.
    if (std::fabs(length - 1) <= findings.tolerance()) return;
    Diagnostic& diagnostic = findings.report(
        entity.rotation.span, "the quaternion of " + title(entity) + " has the length " +
                                  format_rounded(length) + " instead of 1");
    const Quaternion unit = normalized({w, x, y, z});
    diagnostic.help("write the unit quaternion w " + format_rounded(unit.w) + ", x " +
                    format_rounded(unit.x) + ", y " + format_rounded(unit.y) + ", z " +
                    format_rounded(unit.z));
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "turns the root link correctly, but moves the other links and everything in an included scene "
     "by a scaled rotation",
     "MARS SimEntity.cpp:416-434, SMURFLoader.cpp:716, run"},
    {&readers::phobos, Effect::changes, "normalises it, and reads it as x, y, z, w",
     "Phobos representation.py:141-160"},
};

}  // namespace

extern constinit const Rule sml5004_quaternion_not_unit{
    .id = "SML5004",
    .name = "quaternion-not-unit",
    .severity = Severity::warning,
    .summary = "A rotation is a quaternion whose length is not one.",
    .why = "A length of 2.83 puts a child at (-7, 8, 0) instead of (0, 1, 0).",
    .remedy = "Divide the four numbers by the length. This tool normalises them.",
    .check_scene = check,
    .tolerance = {.value = 1e-3, .meaning = "how far the length of the quaternion may be from 1"},
    .facts = kFacts};

}  // namespace smurf::rules::sml5004_quaternion_not_unit_file
