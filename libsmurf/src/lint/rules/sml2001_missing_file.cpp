// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml2001_missing_file_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "cannot read the URDF", "any reader", when(cases::kTheUrdf)},
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "smurf_parser SMURFParser.cpp:45-77, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception",
     "Phobos io/smurfrobot.py:171-197, run"},
};

}  // namespace

extern constinit const Rule sml2001_missing_file{
    .id = "SML2001",
    .name = "missing-file",
    .severity = Severity::error,
    .summary = "`files` lists a file that cannot be read.",
    .remedy = "Correct the path (relative to the .smurf's folder), or delete the entry.",
    .facts = kFacts};

}  // namespace smurf::rules::sml2001_missing_file_file
