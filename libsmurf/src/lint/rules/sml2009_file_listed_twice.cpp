// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml2009_file_listed_twice_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "merges it twice: every motor, sensor and light exists twice, under one name",
     "smurf_parser SMURFParser.cpp:43-69, run"},
    {&readers::phobos, Effect::refuses, "accepts one URDF only", kRun, when(cases::kTheUrdf)},
    {&readers::phobos, Effect::takes, "reads the second one over the first", kRun},
};

}  // namespace

extern constinit const Rule sml2009_file_listed_twice{.id = "SML2009",
                                                      .name = "file-listed-twice",
                                                      .severity = Severity::error,
                                                      .summary = "`files` lists one file twice.",
                                                      .remedy = "List the file once.",
                                                      .facts = kFacts};

}  // namespace smurf::rules::sml2009_file_listed_twice_file
