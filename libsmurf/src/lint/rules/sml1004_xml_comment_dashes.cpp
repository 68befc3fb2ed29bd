// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1004_xml_comment_dashes_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "continues", "urdfdom, run; tinyxml2"},
    {&readers::phobos, Effect::refuses, "refuses the file", "expat, lxml, run"},
};

}  // namespace

extern constinit const Rule sml1004_xml_comment_dashes{
    .id = "SML1004",
    .name = "xml-comment-dashes",
    .severity = Severity::error,
    .summary = "A comment contains `--`.",
    .why = "XML forbids it: browsers (urdf-loader) refuse the file.",
    .remedy = "Write `- -` or another dash.",
    .sources = "urdf-loader 0.13, executed; XML 1.0 section 2.5.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1004_xml_comment_dashes_file
