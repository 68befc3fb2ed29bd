// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::loses, "ignores the element and all it holds",
     "urdfdom, sdformat, DART, MuJoCo, Bullet, run"},
};

}  // namespace

extern constinit const Rule sml1106_unknown_element{
    .id = "SML1106",
    .name = "unknown-element",
    .severity = Severity::warning,
    .summary = "An element that URDF does not define stands where readers look for others.",
    .why = "A misspelt `collision` is a link without collision.",
    .remedy = "Correct the name; foreign data belongs under `robot` or needs a prefix.",
    .facts = kFacts};

}  // namespace smurf::rules
