// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>

#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5030_implausible_pose_file {
namespace {

constexpr double kFarAway = 1e5;    // m; in single precision a centimetre is lost there
constexpr double kManyTurns = 720;  // degrees

void check_position(const Entity& entity, Findings& findings) {
  if (!entity.position) return;
  for (const double number : *entity.position) {
    if (std::fabs(number) <= kFarAway) continue;
    findings.report(entity.position.span, title(entity) + " stands " +
                                              format_rounded(std::fabs(number) / 1000) +
                                              " km away; positions are in metres");
    return;
  }
}

void check_rotation(const Entity& entity, Findings& findings) {
  const RotationForm form = entity.rotation.form;
  if (form != RotationForm::yaw && form != RotationForm::euler) return;
  const std::size_t count = form == RotationForm::yaw ? 1 : 3;
  for (std::size_t i = 0; i < count; ++i) {
    const double degrees = entity.rotation.values[i];
    if (std::fabs(degrees) <= kManyTurns) continue;
    findings.report(entity.rotation.span, title(entity) + " is turned by " +
                                              format_rounded(std::fabs(degrees) / 360) +
                                              " turns; rotations are in degrees");
    return;
  }
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    check_position(entity, findings);
    check_rotation(entity, findings);
  });
}

}  // namespace

extern constinit const Rule sml5030_implausible_pose{
    .id = "SML5030",
    .name = "implausible-pose",
    .severity = Severity::warning,
    .summary = "An entity is implausibly far away, or rotated by many turns.",
    .why = "Scenes take metres and degrees. In single precision, positions at a hundred kilometres "
           "are only accurate to centimetres, and a rotation of many turns is probably in another "
           "unit.",
    .remedy = "Write metres and degrees.",
    .sources = "IEEE 754 single precision.",
    .check_scene = check};

}  // namespace smurf::rules::sml5030_implausible_pose_file
