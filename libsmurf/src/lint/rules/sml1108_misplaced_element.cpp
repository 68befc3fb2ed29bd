// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1108_misplaced_element_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::loses, "ignores the element, with all its contents",
     "urdfdom, MuJoCo, run"},
};

}  // namespace

extern constinit const Rule sml1108_misplaced_element{
    .id = "SML1108",
    .name = "misplaced-element",
    .severity = Severity::warning,
    .summary = "A URDF element is inside an element where it does not belong.",
    .why = "Readers ignore it silently: an `inertial` beside the links gives no link a mass.",
    .remedy = "Move it into the element it belongs to.",
    .sources = "urdfdom, executed.",
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1108_misplaced_element_file
