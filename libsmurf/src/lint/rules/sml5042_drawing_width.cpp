// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5042_drawing_width_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "subtracts y from the width of the page, not from its height; a number with a unit is 0",
     "MARS SMURFLoader.cpp:180, 264-270; Qt QString::toDouble"},
};

}  // namespace

extern constinit const Rule sml5042_drawing_width{
    .id = "SML5042",
    .name = "drawing-width",
    .severity = Severity::error,
    .summary = "The width of a drawn scene is missing or not a plain number.",
    .why =
        "The y axis points down on a page and up in the world. The reader converts one into the other by this width, and shifts all entities when it is wrong.",
    .remedy = "Give the `svg` element a `width` without unit; one unit is one metre.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5042_drawing_width_file
