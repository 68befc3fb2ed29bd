// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, run"},
    {&readers::urdf, Effect::takes, "skips the declaration", "urdfdom, sdformat, MuJoCo, run",
     "#declaration"},
    {&readers::urdf, Effect::takes, "reads no further", "urdfdom, sdformat, MuJoCo, run",
     "#end-tag-behind"},
    {&readers::urdf, Effect::refuses, "refuses the file, or reads no further than the fault",
     "urdfdom, sdformat, MuJoCo, run"},
};

}  // namespace

extern constinit const Rule sml1001_xml_malformed{
    .id = "SML1001",
    .name = "xml-malformed",
    .severity = Severity::error,
    .summary = "A URDF is not well-formed XML.",
    .why =
        "Most readers give no line number, and some accept defects that others refuse: a file that works in one fails in browsers and lxml.",
    .remedy = "Close the element, the quote or the bracket that the message names.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules
