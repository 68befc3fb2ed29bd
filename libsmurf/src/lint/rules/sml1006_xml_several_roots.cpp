// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"

namespace smurf::rules::sml1006_xml_several_roots_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, lxml, run"},
    {&readers::urdf, Effect::refuses,
     "reads the first root element only, and refuses a robot without its other links",
     "urdfdom, sdformat, DART, MuJoCo, run", when(kUncertain)},
    {&readers::urdf, Effect::changes, "reads the first root element only",
     "tinyxml2 FirstChildElement; urdfdom, run"},
};

}  // namespace

extern constinit const Rule sml1006_xml_several_roots{.id = "SML1006",
                                                      .name = "xml-several-roots",
                                                      .severity = Severity::error,
                                                      .summary =
                                                          "A file contains a second root element.",
                                                      .remedy = "Keep one robot per file.",
                                                      .facts = kFacts,
                                                      .blocks_building = true};

}  // namespace smurf::rules::sml1006_xml_several_roots_file
