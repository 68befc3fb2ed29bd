// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules::sml1012_percent_in_value_file {
namespace {

constexpr std::string_view kPrintf =
    "passes the text to printf as a format, which may end the process";
constexpr std::string_view kPrintfRun =
    "urdfdom link.cpp:93 and others, run; fixed in 5.1 (pull request 243)";

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, "/@reference/"},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, "/@filename/"},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, "/@type/"},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, "/@joint/"},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, "/@link/"},
    // Whether it does depends on what stands in memory: it differs between robots.
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, "/cylinder/@radius/#uncertain"},
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, "/cylinder/@length/#uncertain"},
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, "/mass/"},
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, "/sphere/"},
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, "/color/"},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, "/@name/"},
    {&readers::urdfdom, Effect::refuses, "refuses the number, and with it the file", kRun,
     "/joint/"},
    urdfdom_drops_shapes("/link/", kRun),
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, "/@reference/"},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, "/@filename/"},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, "/@type/"},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, "/@joint/"},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, "/@link/"},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, "/@name/"},
    {&readers::mujoco, Effect::refuses, "refuses the number", kRun},
    {&readers::phobos, Effect::takes, "keeps the text", kRun},
};

}  // namespace

extern constinit const Rule sml1012_percent_in_value{
    .id = "SML1012",
    .name = "percent-in-value",
    .severity = Severity::error,
    .summary = "A number, colour or material name contains `%`.",
    .remedy = "Remove the `%`.",
    .sources = "fixed in 5.1.0 (urdfdom pull requests 243, 244).",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1012_percent_in_value_file
