// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml2011_root_not_mapping_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "smurf_parser SMURFParser.cpp:45-77, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, when(cases::kInMain)},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, when(cases::kInScene)},
    {&readers::phobos, Effect::loses, "logs the error and goes on without the file", kRun},
};

}  // namespace

extern constinit const Rule sml2011_root_not_mapping{
    .id = "SML2011",
    .name = "root-not-mapping",
    .severity = Severity::error,
    .summary = "A main, annotation or scene file is empty or does not contain a mapping.",
    .remedy =
        "Write the keys of the file kind (`files:`, `motors:`, `entities:`), or take the file "
        "out of the list that names it.",
    .facts = kFacts};

}  // namespace smurf::rules::sml2011_root_not_mapping_file
