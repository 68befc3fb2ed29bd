// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5041_drawing_transform_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "counts the comma-separated numbers in the first brackets: six are a matrix, two a translation, and everything else is ignored",
     "MARS SMURFLoader.cpp:224-262"},
};

}  // namespace

extern constinit const Rule sml5041_drawing_transform{
    .id = "SML5041",
    .name = "drawing-transform",
    .severity = Severity::error,
    .summary = "MARS interprets a transform of a drawn scene differently than a drawing program.",
    .why = "The entity is not where it is drawn.",
    .remedy = "Write `matrix(a,b,c,d,e,f)` or `translate(x,y)`.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5041_drawing_transform_file
