// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules::sml1001_xml_malformed_file {
namespace {

constexpr std::string_view kRefuses = "refuses the file";

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, run"},
    {&readers::urdf, Effect::takes, "skips the declaration", "urdfdom, sdformat, MuJoCo, run",
     "#declaration"},
    {&readers::urdf, Effect::takes, "stops reading there", "urdfdom, sdformat, MuJoCo, run",
     "#end-tag-behind"},
    // TinyXML, which urdfdom uses, and tinyxml2 read on after different faults. What they make of
    // the rest is not known: there is no fact for those readers.
    {&readers::urdf, Effect::refuses, "refuses the file", "urdfdom, sdformat, MuJoCo, run",
     "#fault"},
    {&readers::gazebo, Effect::refuses, kRefuses, kRun, "#no-tag"},
    {&readers::gazebo, Effect::refuses, kRefuses, kRun, "#comment-behind"},
    {&readers::gazebo, Effect::refuses, kRefuses, kRun, "#instruction"},
    {&readers::gazebo, Effect::refuses, kRefuses, kRun, "#text-behind-declaration"},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, "#no-tag"},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, "#comment-behind"},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, "#instruction"},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, "#typographic-quotes"},
    {&readers::urdfdom, Effect::refuses, kRefuses, kRun, "#text-behind-declaration"},
    {&readers::ros, Effect::refuses, kRefuses, "urdfdom 3.0.1, run", "#end-tag-attribute"},
    {&readers::dart, Effect::refuses, kRefuses, kRun, "#end-tag-attribute"},
};

}  // namespace

extern constinit const Rule sml1001_xml_malformed{
    .id = "SML1001",
    .name = "xml-malformed",
    .severity = Severity::error,
    .summary = "A URDF is not well-formed XML.",
    .why =
        "Most readers give no line number, and some accept defects that others refuse: a file that works in one fails in browsers and lxml.",
    .remedy = "Close the element, the quote or the bracket that the message names.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1001_xml_malformed_file
