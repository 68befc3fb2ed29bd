// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml4004_missing_key_file {
namespace {

constexpr std::string_view kNameless = "keeps an entry without a name";

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "has no URDF without `files`, and dereferences the null model", "MARS smurf.cpp:988-998, run",
     when(cases::kLacksFiles)},
    {&readers::mars, Effect::changes, "reads 0 or an empty text", "configmaps, run"},
    {&readers::phobos, Effect::breaks, kNameless, kRun,
     at("materials/name").when(cases::kEmptyKey)},
    {&readers::phobos, Effect::breaks, kNameless, kRun, at("joint/name").when(cases::kEmptyKey)},
    {&readers::phobos, Effect::breaks, kNameless, kRun, at("visuals/name").when(cases::kEmptyKey)},
    {&readers::phobos, Effect::breaks, kNameless, kRun,
     at("submechanisms/name").when(cases::kEmptyKey)},
    {&readers::phobos, Effect::refuses, "stops with a KeyError", "Phobos smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml4004_missing_key{.id = "SML4004",
                                                .name = "missing-key",
                                                .severity = Severity::error,
                                                .summary =
                                                    "An entry or a main file lacks a required key.",
                                                .remedy = "Add the key.",
                                                .facts = kFacts};

}  // namespace smurf::rules::sml4004_missing_key_file
