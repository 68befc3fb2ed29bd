// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/file_cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"

namespace smurf::rules::sml0004_control_character_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "keeps the byte inside names and values",
     "urdfdom, sdformat, DART, MuJoCo, run", when(cases::kInUrdf)},
    {&readers::urdf, Effect::takes, "stops reading at the NUL, where the robot has ended",
     "urdfdom, sdformat, DART, MuJoCo, Drake, Pinocchio, PyBullet, run", when(cases::kPadding)},
    {&readers::pybullet, Effect::refuses, "leaves out the rest of the line, whatever it is", kRun,
     when(kUncertain)},
    {&readers::urdf, Effect::refuses, "refuses the file, or stops reading there", "urdfdom, run"},
    {&readers::mars, Effect::changes, "keeps the byte inside names and values",
     "yaml-cpp 0.7, run"},
    {&readers::phobos, Effect::loses, "logs the error and continues without the annotations", kRun,
     when(cases::kInAnnotations)},
    {&readers::phobos, Effect::refuses, "refuses the file", "PyYAML 6.0 and expat, run"},
};

}  // namespace

extern constinit const Rule sml0004_control_character{
    .id = "SML0004",
    .name = "control-character",
    .severity = Severity::error,
    .summary = "A file contains a control character that its format, YAML or XML, does not allow.",
    .why = "Editors do not show the byte, so names that look alike differ.",
    .remedy = "Delete the character.",
    .sources = "YAML 1.2 section 5.1; XML 1.0 section 2.2.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0004_control_character_file
