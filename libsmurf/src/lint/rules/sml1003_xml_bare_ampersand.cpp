// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1003_xml_bare_ampersand_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::takes, "continues", kRun, when(cases::kCharacter)},
    {&readers::urdfdom, Effect::refuses, "refuses the file", kRun, when(cases::kCharacter)},
    {&readers::dart, Effect::refuses, "refuses the file", kRun, when(cases::kCharacter)},
    {&readers::drake, Effect::refuses, "reads an empty name, which it refuses", kRun,
     at("visual/@name").when(cases::kCharacter)},
    {&readers::drake, Effect::refuses, "reads an empty name, which it refuses", kRun,
     at("collision/@name").when(cases::kCharacter)},
    {&readers::urdf, Effect::takes, "continues", "urdfdom, sdformat, MuJoCo and Bullet, run"},
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, lxml, run"},
};

}  // namespace

extern constinit const Rule sml1003_xml_bare_ampersand{
    .id = "SML1003",
    .name = "xml-bare-ampersand",
    .severity = Severity::error,
    .summary = "An `&` does not begin a character reference.",
    .why = "Browsers (urdf-loader) refuse the file.",
    .remedy = "Write `&amp;`.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1003_xml_bare_ampersand_file
