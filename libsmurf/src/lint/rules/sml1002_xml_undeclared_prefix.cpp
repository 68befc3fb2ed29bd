// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1002_xml_undeclared_prefix_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "does not look at prefixes", "urdfdom, run; tinyxml2"},
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, lxml, run"},
};

}  // namespace

extern constinit const Rule sml1002_xml_undeclared_prefix{
    .id = "SML1002",
    .name = "xml-undeclared-prefix",
    .severity = Severity::error,
    .summary = "An element or attribute uses a namespace prefix that is not declared.",
    .why = "Browsers (urdf-loader) refuse the whole file.",
    .remedy = "Declare the prefix on the robot element with xmlns:prefix, or remove the element.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1002_xml_undeclared_prefix_file
