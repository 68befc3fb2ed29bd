// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1014_xml_missing_blank_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "continues", "urdfdom, sdformat, run; tinyxml2"},
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, run; lxml"},
};

}  // namespace

extern constinit const Rule sml1014_xml_missing_blank{
    .id = "SML1014",
    .name = "xml-missing-blank",
    .severity = Severity::error,
    .summary = "There is no space between two attributes.",
    .why = "Browsers (urdf-loader) and Python's readers refuse the file.",
    .remedy = "Insert a space before the second attribute.",
    .sources = "XML 1.0 section 3.1; expat, executed.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1014_xml_missing_blank_file
