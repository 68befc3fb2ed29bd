// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1005_xml_junk_before_prolog_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "reads the first declaration only",
     "urdfdom, sdformat, DART, MuJoCo, run", when(cases::kSecond)},
    {&readers::urdfdom, Effect::takes, "skips blanks", kRun, when(cases::kBlanks)},
    {&readers::mujoco, Effect::takes, "skips blanks", kRun, when(cases::kBlanks)},
    {&readers::drake, Effect::takes, "skips blanks", kRun, when(cases::kBlanks)},
    {&readers::pybullet, Effect::takes, "skips blanks", kRun, when(cases::kBlanks)},
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, lxml, run"},
};

}  // namespace

extern constinit const Rule sml1005_xml_junk_before_prolog{
    .id = "SML1005",
    .name = "xml-junk-before-prolog",
    .severity = Severity::error,
    .summary = "There is text before the XML declaration.",
    .why = "The declaration must be the first thing in the file; otherwise browsers (urdf-loader), "
           "expat and yourdfpy refuse the file.",
    .remedy = "Delete everything before `<?xml`.",
    .sources = "urdf-loader 0.13, executed; XML 1.0 section 2.8.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1005_xml_junk_before_prolog_file
