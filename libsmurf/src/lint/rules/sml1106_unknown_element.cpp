// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1106_unknown_element_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::loses, "ignores the element, with all its contents",
     "urdfdom, sdformat, DART, MuJoCo, Bullet, run"},
};

}  // namespace

extern constinit const Rule sml1106_unknown_element{
    .id = "SML1106",
    .name = "unknown-element",
    .severity = Severity::warning,
    .summary = "An unknown element is in a place where readers expect elements of URDF.",
    .why = "Readers ignore the element: a misspelt `collision` leaves the link without collision.",
    .remedy = "Correct the name; foreign data belongs under `robot` or needs a prefix.",
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1106_unknown_element_file
