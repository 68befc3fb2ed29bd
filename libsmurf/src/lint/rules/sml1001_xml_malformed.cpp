// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1001_xml_malformed_file {
namespace {

constexpr std::string_view kRefuses = "refuses the file";

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, run"},
    {&readers::urdf, Effect::takes, "skips the declaration", "urdfdom, sdformat, MuJoCo, run",
     when(cases::kDeclaration)},
    {&readers::urdf, Effect::takes, "does not look at the declaration",
     "urdfdom, sdformat, MuJoCo, run", when(cases::kUnquotedInDeclaration)},
    {&readers::urdf, Effect::takes, "stops reading there", "urdfdom, sdformat, MuJoCo, run",
     when(cases::kEndTagBehind)},
    // TinyXML, which urdfdom uses, and tinyxml2 read on after different faults. What they make of
    // the rest is not known: there is no fact for those readers.
    {&readers::urdf, Effect::refuses, "refuses the file", "urdfdom, sdformat, MuJoCo, run",
     when(cases::kFault)},
    {&readers::gazebo, Effect::refuses, kRefuses, kRun, when(cases::kNoTag)},
    {&readers::gazebo, Effect::refuses, kRefuses, kRun, when(cases::kCommentBehind)},
    {&readers::gazebo, Effect::refuses, kRefuses, kRun, when(cases::kInstruction)},
    {&readers::gazebo, Effect::refuses, kRefuses, kRun, when(cases::kTextBehindDeclaration)},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, when(cases::kNoTag)},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, when(cases::kCommentBehind)},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, when(cases::kInstruction)},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, when(cases::kTypographicQuotes)},
    {&readers::urdfdom, Effect::refuses, kRefuses, kRun, when(cases::kTextBehindDeclaration)},
    {&readers::ros, Effect::refuses, kRefuses, "urdfdom 3.0.1, run", when(cases::kEndTagAttribute)},
    {&readers::dart, Effect::refuses, kRefuses, kRun, when(cases::kEndTagAttribute)},
};

}  // namespace

extern constinit const Rule sml1001_xml_malformed{
    .id = "SML1001",
    .name = "xml-malformed",
    .severity = Severity::error,
    .summary = "A URDF is not well-formed XML.",
    .why =
        "Most readers give no line number, and some accept defects that others refuse: a file that works in one fails in browsers and lxml.",
    .remedy =
        "Close the element, the quote or the bracket that the message names; delete what is no XML.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1001_xml_malformed_file
