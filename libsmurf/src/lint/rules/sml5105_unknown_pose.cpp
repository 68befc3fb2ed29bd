// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5105_unknown_pose_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "leaves all joints at zero", "MARS SimEntity.cpp:505-511"},
    {&readers::mars2, Effect::breaks, "reports an error and leaves all joints at zero",
     "MarsSceneLoader.cpp:338-346"},
    {&readers::phobos, Effect::ignores, "does not look at poses", kRun},
};

}  // namespace

extern constinit const Rule sml5105_unknown_pose{
    .id = "SML5105",
    .name = "unknown-pose",
    .severity = Severity::error,
    .summary = "`pose` names a joint pose set that the model does not have.",
    .remedy = "Correct the name, or add the set to the section `poses` of the model.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5105_unknown_pose_file
