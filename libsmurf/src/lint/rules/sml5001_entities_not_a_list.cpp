// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "MARS SMURFLoader.cpp:322; configmaps, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5001_entities_not_a_list{
    .id = "SML5001",
    .name = "entities-not-a-list",
    .severity = Severity::error,
    .summary = "`entities`, `smurfs` or `smurfa` is not a list.",
    .remedy = "Make every entity an item of a list: `- name: Eve`.",
    .facts = kFacts};

}  // namespace smurf::rules
