// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1013_dtd_or_xinclude_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::refuses, "finds no robot after the declarations", kRun,
     when(cases::kDeclarations).before({4, 0})},
    {&readers::urdfdom, Effect::takes, "skips the declarations", "4.0.1, run",
     when(cases::kDeclarations)},
    {&readers::mujoco, Effect::takes, "skips the declarations", kRun, when(cases::kDeclarations)},
    {&readers::pybullet, Effect::changes,
     "skips the declarations, and reads their entities as text", kRun, when(cases::kDeclarations)},
};

}  // namespace

extern constinit const Rule sml1013_dtd_or_xinclude{
    .id = "SML1013",
    .name = "dtd-or-xinclude",
    .severity = Severity::warning,
    .summary = "A URDF uses a document type with declarations, a custom entity or XInclude.",
    .why = "TinyXML and tinyxml2 do not expand them, lxml may: the same file describes two robots.",
    .remedy = "Write the text out.",
    .sources =
        "urdfdom and tinyxml2 9.0, executed (tinyxml2 issue 1082: unknown entities corrupt the "
        "text).",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1013_dtd_or_xinclude_file
