// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5304_step_size_in_seconds_file {
namespace {

/// Simulations step by 0.1 ms to 20 ms; as seconds these numbers are below this.
constexpr double kSmallestMilliseconds = 0.05;
/// With steps of a second, bodies fall through each other.
constexpr double kLargestMilliseconds = 1000;

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.scene.physics || !world_value(file, "physics")) continue;
    const Field<double>& step = file.scene.physics->step_size;
    if (step && *step >= kLargestMilliseconds) {
      findings.report(step.span, "the step is " + format_number(*step / 1000) +
                                     " seconds long; the key is in milliseconds");
    }
    if (!step || *step < 0 || *step >= kSmallestMilliseconds) continue;
    if (*step == 0) {
      findings.report(step.span, "with a step of 0 ms, the simulation does not advance");
      continue;
    }
    const std::string milliseconds = format_rounded(*step * 1000, 12);
    Diagnostic& diagnostic = findings.report(step.span, "the step is " + format_number(*step) +
                                                            " milliseconds; are seconds meant?");
    diagnostic.help("in milliseconds it is " + milliseconds);
    diagnostic.fixes.push_back({Applicability::unsafe, {{step.span, milliseconds}}});
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "reads milliseconds", "MARS SMURFLoader.cpp:471-473"},
    {&readers::pybullet, Effect::crashes,
     "stops with a TypeError at `stepsize` (the script of Phobos)",
     "Phobos scripts/smurfs_in_pybullet.py, run"},
};

}  // namespace

extern constinit const Rule sml5304_step_size_in_seconds{
    .id = "SML5304",
    .name = "step-size-in-seconds",
    .severity = Severity::warning,
    .summary = "The step of the physics engine is far too small or too large.",
    .why = "A simulation runs a thousand times slower than it should.",
    .remedy = "Write milliseconds: 1 for a thousand steps a second.",
    .check_scene = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml5304_step_size_in_seconds_file
