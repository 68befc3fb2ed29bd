// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules::sml1446_dont_collapse_false_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const xml::Attribute* attribute =
        xml::View(model.robot->document, joint.element).attribute("dont_collapse");
    if (attribute == nullptr || (attribute->value() != "false" && attribute->value() != "0"))
      return;
    Diagnostic& diagnostic = findings.report(
        attribute->span(), "importers that know `dont_collapse` read any value as true");
    diagnostic.help("delete the attribute");
    diagnostic.fixes.push_back({Applicability::unsafe, {{attribute->span(), ""}}});
  });
}

}  // namespace

extern constinit const Rule sml1446_dont_collapse_false{
    .id = "SML1446",
    .name = "dont-collapse-false",
    .severity = Severity::warning,
    .summary = "A joint has `dont_collapse=\"false\"`, which importers read as true.",
    .why =
        "The older importer of Omniverse only checks whether the attribute is there: any value keeps the fixed joint from "
        "being merged.",
    .remedy = "Delete the attribute.",
    .sources = "Isaac importer UrdfParser.cpp:1270-1274.",
    .check_model = check,
    .about = About::format};

}  // namespace smurf::rules::sml1446_dont_collapse_false_file
