// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1018_xml_version_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "does not look at the declaration",
     "urdfdom, sdformat, MuJoCo, run"},
};

}  // namespace

extern constinit const Rule sml1018_xml_version{
    .id = "SML1018",
    .name = "xml-version",
    .severity = Severity::warning,
    .summary = "The XML declaration names no version of XML that exists.",
    .why = "Browsers, urdf-loader, lxml and xmllint refuse the file.",
    .remedy = "Write `version=\"1.0\"`.",
    .sources = "XML 1.0 section 2.8; 37 of 991 robots of 70 repositories.",
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1018_xml_version_file
