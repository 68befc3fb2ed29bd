// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml2004_absolute_path_file {

namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "puts the folder of the .smurf before it, and does not find the file",
     "smurf_parser SMURFParser.cpp:40-54, run"},
    {&readers::mars2, Effect::crashes,
     "puts the folder of the .smurf before it, and does not find the file",
     "smurf_parser SMURFParser.cpp:40-54, run"},
    {&readers::envire, Effect::crashes,
     "puts the folder of the .smurf before it, and does not find the file",
     "smurf_parser SMURFParser.cpp:40-54, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml2004_absolute_path{
    .id = "SML2004",
    .name = "absolute-path",
    .severity = Severity::error,
    .summary = "`files` lists an absolute path.",
    .why = "The path exists on one machine only.",
    .remedy = "Write the path relative to the .smurf's folder.",
    .facts = kFacts};

}  // namespace smurf::rules::sml2004_absolute_path_file
