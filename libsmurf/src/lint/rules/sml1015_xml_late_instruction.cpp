// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1015_xml_late_instruction_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file", "tinyxml2, run"},
    {&readers::urdfdom, Effect::takes, "skips it", "TinyXML; 4.0.1, run", before({4, 0})},
    {&readers::gazebo, Effect::refuses, "refuses the file", "tinyxml2, run"},
    {&readers::phobos, Effect::takes, "skips it", "expat, run; lxml"},
};

}  // namespace

extern constinit const Rule sml1015_xml_late_instruction{
    .id = "SML1015",
    .name = "xml-late-instruction",
    .severity = Severity::error,
    .summary = "A processing instruction comes after the start of the root element.",
    .why = "This is valid XML, but one of the two parsers behind URDF readers in C++ stops reading "
           "there.",
    .remedy = "Delete it, or move it to the start of the file.",
    .sources = "XML 1.0 section 2.6; tinyxml2 XMLNode::ParseDeep.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1015_xml_late_instruction_file
