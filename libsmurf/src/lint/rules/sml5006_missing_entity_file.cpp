// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5006_missing_entity_file_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception", "MARS SMURFLoader.cpp"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5006_missing_entity_file{
    .id = "SML5006",
    .name = "missing-entity-file",
    .severity = Severity::error,
    .summary = "An entity names a file that cannot be read.",
    .remedy =
        "Correct the path; it is relative to the folder of the scene that contains the entity.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5006_missing_entity_file_file
