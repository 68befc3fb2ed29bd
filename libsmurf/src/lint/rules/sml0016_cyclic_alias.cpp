// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0016_cyclic_alias_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "recurses until its stack overflows",
     "configmaps copies aliases"},
    {&readers::phobos, Effect::takes, "reads the value", kRun},
};

}  // namespace

extern constinit const Rule sml0016_cyclic_alias{
    .id = "SML0016",
    .name = "cyclic-alias",
    .severity = Severity::error,
    .summary = "An alias is inside the value that it repeats.",
    .why = "The value would contain itself: readers that follow aliases recurse until the stack "
           "overflows.",
    .remedy = "Remove the alias.",
    .sources = "yaml-cpp 0.7, executed.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0016_cyclic_alias_file
