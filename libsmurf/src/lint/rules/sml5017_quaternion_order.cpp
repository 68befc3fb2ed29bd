// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5017_quaternion_order_file {
namespace {

constexpr double kZero = 1e-6;

/// Whether these numbers are plausible only as x, y, z, w: then they are a turn about at most one
/// axis of the frame. As w, x, y, z, they are a half turn about an oblique axis, or the half turn
/// that is the identity as x, y, z, w.
bool looks_like_xyzw(const std::array<double, 4>& numbers) {
  const auto is_zero = [&](std::size_t i) { return std::fabs(numbers[i]) < kZero; };
  return is_zero(0) && !is_zero(3) && (is_zero(1) || is_zero(2));
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    const Rotation& rotation = entity.rotation;
    if (rotation.form != RotationForm::quaternion || rotation.is_mapping) return;
    if (!looks_like_xyzw(rotation.values)) return;
    Diagnostic& diagnostic =
        findings.report(rotation.span, "the quaternion of " + title(entity) +
                                           " is a half turn as w, x, y, z; are "
                                           "these x, y, z, w?");
    std::vector<Span> places;
    std::vector<std::string> texts;
    for (const yaml::View number : mapping_of(file, entity).find("rotation")) {
      places.push_back(number.span());
      texts.emplace_back(number.text());
    }
    diagnostic.help("then write [" + texts[3] + ", " + texts[0] + ", " + texts[1] + ", " +
                    texts[2] + "]; a half turn about z is [180]");
    Fix& fix = diagnostic.fixes.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) fix.edits.push_back({places[i], texts[(i + 3) % 4]});
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "reads w, x, y, z", "MARS SimEntity.cpp:416-421"},
    {&readers::mars2, Effect::changes, "reads w, x, y, z", "MarsSceneLoader.cpp"},
    {&readers::phobos, Effect::takes, "reads x, y, z, w",
     "Phobos representation.py (Pose.rotation)"},
};

}  // namespace

extern constinit const Rule sml5017_quaternion_order{
    .id = "SML5017",
    .name = "quaternion-order",
    .severity = Severity::warning,
    .summary = "Four numbers of a rotation make more sense as x, y, z, w than as w, x, y, z.",
    .why = "[0, 0, 0, 1] is the identity rotation in one order and half a turn in the other.",
    .remedy = "Put w first, or write {w: , x: , y: , z: }, which is the same in both orders.",
    .check_scene = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml5017_quaternion_order_file
