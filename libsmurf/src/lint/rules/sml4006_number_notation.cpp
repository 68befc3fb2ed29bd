// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml4006_number_notation_file {

namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "reads whole numbers with scanf's %d, which stops at the first character that is not a digit: `1e3` is 1, `0x10` is 0",
     "configmaps ConfigAtom.hpp:335-386, run"},
    {&readers::phobos, Effect::takes, "reads the number", kRun},
};

}  // namespace

extern constinit const Rule sml4006_number_notation{
    .id = "SML4006",
    .name = "number-notation",
    .severity = Severity::error,
    .summary = "A number is written in a notation that MARS reads as another number.",
    .why = "Numbers with a fraction may have exponents; `0o17` is 0 in both.",
    .remedy = "Write plain decimal digits.",
    .facts = kFacts};

}  // namespace smurf::rules::sml4006_number_notation_file
