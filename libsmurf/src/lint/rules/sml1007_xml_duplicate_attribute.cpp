// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1007_xml_duplicate_attribute_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file", "urdfdom, MuJoCo, run"},
};

}  // namespace

extern constinit const Rule sml1007_xml_duplicate_attribute{
    .id = "SML1007",
    .name = "xml-duplicate-attribute",
    .severity = Severity::error,
    .summary = "An element has the same attribute twice.",
    .remedy = "Delete one of the two.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1007_xml_duplicate_attribute_file
