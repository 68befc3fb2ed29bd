// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5009_entity_type_mismatch_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "uses the type and fails on the file",
     "MARS SMURFLoader.cpp:319-322"},
    {&readers::mars2, Effect::changes, "uses the extension", "MarsSceneLoader.cpp:206-226"},
    {&readers::phobos, Effect::changes, "uses the extension", "Phobos multiple.py",
     when(cases::kOfAnotherKind)},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun},
};

}  // namespace

extern constinit const Rule sml5009_entity_type_mismatch{
    .id = "SML5009",
    .name = "entity-type-mismatch",
    .severity = Severity::error,
    .summary = "The type of an entity and the extension of its file disagree.",
    .remedy = "Leave `type` out, or make it smurf for a .smurf and urdf for a .urdf.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5009_entity_type_mismatch_file
