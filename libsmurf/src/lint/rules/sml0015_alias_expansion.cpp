// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0015_alias_expansion_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "runs out of memory", "configmaps copies aliases"},
};

}  // namespace

extern constinit const Rule sml0015_alias_expansion{
    .id = "SML0015",
    .name = "alias-expansion",
    .severity = Severity::error,
    .summary = "Aliases multiply a small file into an enormous value.",
    .why =
        "Readers that copy aliases (configmaps does) run out of memory; this is how a few hundred "
        "bytes stop a server.",
    .remedy = "Write the values out, or use fewer aliases of aliases.",
    .sources = "yaml-cpp 0.7, executed: nine levels of nine aliases are 490 million nodes.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0015_alias_expansion_file
