// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::crashes,
     "passes the text to printf as a format, which may end the process",
     "urdfdom link.cpp:93 and others, run; fixed in 5.1 (pull request 243)"},
};

}  // namespace

extern constinit const Rule sml1012_percent_in_value{
    .id = "SML1012",
    .name = "percent-in-value",
    .severity = Severity::error,
    .summary = "A number, colour or material name holds `%`.",
    .remedy = "Remove the `%`.",
    .sources = "fixed in 5.1.0 (urdfdom pull requests 243, 244).",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules
