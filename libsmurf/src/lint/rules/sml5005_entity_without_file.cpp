// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5005_entity_without_file_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "includes nothing", "MARS 71a5c45, run", when(cases::kOfScene)},
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "MARS SMURFLoader.cpp:319-322"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5005_entity_without_file{
    .id = "SML5005",
    .name = "entity-without-file",
    .severity = Severity::error,
    .summary = "An entity names no file and no type.",
    .remedy =
        "Add `file:` with the model or scene, and `type:` when the extension does not determine "
        "the type.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5005_entity_without_file_file
