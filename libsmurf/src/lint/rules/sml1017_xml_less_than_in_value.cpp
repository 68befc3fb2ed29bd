// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1017_xml_less_than_in_value_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "continues", "urdfdom, sdformat, MuJoCo, run; tinyxml2"},
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, run; lxml"},
};

}  // namespace

extern constinit const Rule sml1017_xml_less_than_in_value{
    .id = "SML1017",
    .name = "xml-less-than-in-value",
    .severity = Severity::error,
    .summary = "The value of an attribute contains `<`.",
    .why = "Browsers (urdf-loader) and the readers of Python refuse the file.",
    .remedy = "Write `&lt;`.",
    .sources = "XML 1.0 section 3.1; expat, executed.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1017_xml_less_than_in_value_file
