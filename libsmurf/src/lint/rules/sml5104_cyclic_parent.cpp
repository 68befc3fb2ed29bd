// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5104_cyclic_parent_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "creates them in file order, the first in the world frame",
     "MARS SMURFLoader.cpp:580-637, run"},
};

}  // namespace

extern constinit const Rule sml5104_cyclic_parent{
    .id = "SML5104",
    .name = "cyclic-parent",
    .severity = Severity::error,
    .summary = "Entities are placed relative to each other in a cycle.",
    .why = "No placement satisfies all of them.",
    .remedy = "Place one of them relative to the world or to another entity.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5104_cyclic_parent_file
