// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"

namespace smurf::rules::sml1012_percent_in_value_file {
namespace {

constexpr std::string_view kPrintf =
    "passes the text to printf as a format, which may end the process";
constexpr std::string_view kPrintfRun =
    "urdfdom link.cpp:93 and others, run; fixed in 5.1 (pull request 243)";

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "reads the leading digits, or 0", kRun},
    {&readers::drake, Effect::takes, "keeps the name", kRun, at("material/@name")},
    {&readers::drake, Effect::refuses, "refuses the number", kRun},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, at("@reference")},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, at("@filename")},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, at("@type")},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, at("@joint")},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, at("@link")},
    // Whether it does depends on what stands in memory: it differs between robots.
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun,
     at("cylinder/@radius").when(kUncertain).before({5, 1})},
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun,
     at("cylinder/@length").when(kUncertain).before({5, 1})},
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, at("mass").before({5, 1})},
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, at("sphere").before({5, 1})},
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, at("color").before({5, 1})},
    {&readers::urdfdom, Effect::takes, "keeps the text", kRun, at("@name")},
    {&readers::urdfdom, Effect::refuses, "refuses the number, and with it the file", kRun,
     at("joint")},
    urdfdom_drops_shapes(at("link"), kRun),
    {&readers::urdfdom, Effect::crashes, kPrintf, kPrintfRun, before({5, 1})},
    {&readers::urdfdom, Effect::loses, "drops the material with a message",
     "urdfdom link.cpp:86-94", at("material")},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, at("@reference")},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, at("@filename")},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, at("@type")},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, at("@joint")},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, at("@link")},
    {&readers::mujoco, Effect::takes, "reads the text", kRun, at("@name")},
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
    .blocks_building = true,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1012_percent_in_value_file
