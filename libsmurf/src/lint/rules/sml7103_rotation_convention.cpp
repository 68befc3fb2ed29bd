// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7103_rotation_convention_file {
namespace {

constexpr Circumstance kQuaternion{"quaternion"};
constexpr Circumstance kYaw{"yaw"};

std::string_view form_of(const Rotation& rotation) {
  switch (rotation.form) {
  case RotationForm::yaw: return "yaw";
  case RotationForm::euler: return "euler";
  case RotationForm::quaternion: return "quaternion";
  case RotationForm::absent:
  case RotationForm::invalid: break;
  }
  return {};
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    const Rotation& rotation = entity.rotation;
    const std::string_view form = form_of(rotation);
    if (form.empty() || rotation.is_mapping) return;
    const bool is_zero = std::all_of(rotation.values.begin(), rotation.values.end(),
                                     [](double value) { return value == 0; });
    if (is_zero) return;
    Diagnostic& diagnostic = findings.report(
        rotation.span, "the rotation of " + title(entity) + " is written as " +
                           (form == "quaternion" ? "a quaternion w, x, y, z" : "degrees"));
    if (form == "quaternion") diagnostic.when(kQuaternion);
    if (form == "yaw") diagnostic.when(kYaw);
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "reads one or three numbers as degrees and four as w, x, y, z",
     "MARS SimEntity.cpp:405-431"},
    {&readers::mars2, Effect::takes, "reads one or three numbers as degrees and four as w, x, y, z",
     "MARS SimEntity.cpp:405-431"},
    {&readers::phobos, Effect::changes, "reads x, y, z, w", "Phobos utils/transform.py:9-48",
     when(kQuaternion)},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, when(kYaw)},
    {&readers::phobos, Effect::changes, "reads radians", "Phobos utils/transform.py:9-48"},
    {&readers::pybullet, Effect::crashes, "stops with an exception",
     "Phobos scripts/smurfs_in_pybullet.py:115-122, run", when(kQuaternion)},
};

}  // namespace

extern constinit const Rule sml7103_rotation_convention{
    .id = "SML7103",
    .name = "rotation-convention",
    .severity = Severity::warning,
    .summary = "A target reads a rotation as a different rotation.",
    .remedy = "For Phobos 2 write a mapping with the keys w, x, y, z, which MARS reads since 2025.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7103_rotation_convention_file
