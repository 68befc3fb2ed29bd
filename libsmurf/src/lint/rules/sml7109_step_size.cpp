// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7109_step_size_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  constexpr double kSmallestMilliseconds = 0.05;  // below, seconds are meant: SML5304
  for (const SceneFile& file : scene.scenes) {
    if (!file.scene.physics || !file.scene.physics->step_size) continue;
    if (*file.scene.physics->step_size < kSmallestMilliseconds) continue;
    findings.report(file.scene.physics->step_size.span,
                    "the step is " + format_rounded(*file.scene.physics->step_size) + " ms");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "reads milliseconds", "MARS SMURFLoader.cpp:471-473"},
    {&readers::pybullet, Effect::crashes, "stops with a TypeError at `stepsize`",
     "Phobos scripts/smurfs_in_pybullet.py:92-96, run"},
};

}  // namespace

extern constinit const Rule sml7109_step_size{
    .id = "SML7109",
    .name = "step-size",
    .severity = Severity::warning,
    .summary = "A scene sets the step size of the physics, and a target reads it in another unit.",
    .remedy = "Set the step size in the script that starts PyBullet.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7109_step_size_file
