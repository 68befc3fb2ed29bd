// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1016_xml_missing_quotes_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file", "tinyxml2, run"},
    {&readers::urdfdom, Effect::takes, "reads the value up to a space, `/` or `>`",
     "TinyXML; 4.0.1, run", before({4, 0})},
    {&readers::gazebo, Effect::refuses, "refuses the file", "tinyxml2, run"},
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, run; lxml"},
};

}  // namespace

extern constinit const Rule sml1016_xml_missing_quotes{
    .id = "SML1016",
    .name = "xml-missing-quotes",
    .severity = Severity::error,
    .summary = "The value of an attribute has no quotes.",
    .why = "Only one of the parsers that URDF readers use accepts such a value.",
    .remedy = "Put the value in quotes.",
    .sources = "XML 1.0 section 3.1; TinyXML TiXmlAttribute::Parse.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1016_xml_missing_quotes_file
