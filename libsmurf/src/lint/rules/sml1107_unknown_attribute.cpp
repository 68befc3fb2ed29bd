// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1107_unknown_attribute_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::changes, "ignores the attribute", "urdfdom, MuJoCo, run"},
};

}  // namespace

extern constinit const Rule sml1107_unknown_attribute{
    .id = "SML1107",
    .name = "unknown-attribute",
    .severity = Severity::warning,
    .summary = "An element has an attribute that URDF does not define.",
    .why = "Readers ignore the attribute, so its value is missing.",
    .remedy = "Correct the name; foreign attributes need a prefix.",
    .sources = "186 of 797 public files.",
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1107_unknown_attribute_file
