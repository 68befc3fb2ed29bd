// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "reads uninitialised memory, or ends with an uncaught exception",
     "configmaps ConfigAtom.hpp:83-91, run"},
};

}  // namespace

extern constinit const Rule sml4001_wrong_type{
    .id = "SML4001",
    .name = "wrong-type",
    .severity = Severity::error,
    .summary = "A key holds a value of the wrong kind.",
    .why = "`yes`, `abc` and `.inf` are texts, not numbers or booleans.",
    .remedy = "Write the kind of value that the message names; `smurf-lint --explain` of the key's "
              "section and the schemas list them.",
    .facts = kFacts};

}  // namespace smurf::rules
