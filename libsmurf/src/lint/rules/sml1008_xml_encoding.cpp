// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1008_xml_encoding_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "reads UTF-8 anyway", kRun, when(cases::kWide)},
    {&readers::mujoco, Effect::takes, "reads UTF-8 anyway", kRun, when(cases::kWide)},
};

}  // namespace

extern constinit const Rule sml1008_xml_encoding{
    .id = "SML1008",
    .name = "xml-encoding",
    .severity = Severity::error,
    .summary = "The XML declaration names an encoding that the file does not have.",
    .why =
        "expat, lxml and browsers (urdf-loader) refuse UTF-8 that is declared as UTF-16. Only some "
        "readers convert text that is declared as ISO-8859-1: names with non-ASCII characters "
        "differ from reader to reader.",
    .remedy = "Declare UTF-8, or leave the encoding out.",
    .sources =
        "urdfdom (converts), MuJoCo (does not) and urdf-loader 0.13, executed; XML 1.0 section 4.3.3.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1008_xml_encoding_file
