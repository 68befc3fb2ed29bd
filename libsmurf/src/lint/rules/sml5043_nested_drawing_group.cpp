// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5043_nested_drawing_group_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "treats every group as an entity",
     "MARS SMURFLoader.cpp:205-215"},
};

}  // namespace

extern constinit const Rule sml5043_nested_drawing_group{
    .id = "SML5043",
    .name = "nested-drawing-group",
    .severity = Severity::warning,
    .summary = "A group of a drawn scene contains other groups.",
    .why = "smurfs-flatten follows the picture: it does not treat a layer as an entity.",
    .remedy = "Ungroup, and draw without layers.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5043_nested_drawing_group_file
