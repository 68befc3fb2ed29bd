// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0011_duplicate_key_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "uses the first value", "configmaps ConfigMap.cpp:53, run"},
    {&readers::mars2, Effect::changes, "uses the first value", "configmaps ConfigMap.cpp:53, run"},
    {&readers::envire, Effect::changes, "uses the first value", "configmaps ConfigMap.cpp:53, run"},
    {&readers::phobos, Effect::changes, "uses the last value", "PyYAML"},
};

}  // namespace

extern constinit const Rule sml0011_duplicate_key{
    .id = "SML0011",
    .name = "duplicate-key",
    .severity = Severity::error,
    .summary = "A mapping contains the same key twice.",
    .why = "Readers build different robots from the same file.",
    .remedy = "Delete one of the two, or rename it.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0011_duplicate_key_file
