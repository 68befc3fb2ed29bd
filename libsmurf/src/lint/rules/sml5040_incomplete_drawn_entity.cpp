// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5040_incomplete_drawn_entity_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "MARS SMURFLoader.cpp:205-262"},
};

}  // namespace

extern constinit const Rule sml5040_incomplete_drawn_entity{
    .id = "SML5040",
    .name = "incomplete-drawn-entity",
    .severity = Severity::error,
    .summary = "A group of a drawn scene does not describe an entity.",
    .why = "The title of the group must name a YAML file, the description must contain "
           "`origin_z: NUMBER`, and the first path must begin with `m X,Y`.",
    .remedy = "Give the group a `<title>`, a `<desc>` and a path of this form, or move "
              "decorative shapes out of groups.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5040_incomplete_drawn_entity_file
