// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1115_no_links_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !model.robot->links.empty()) return;
  const xml::Document& document = model.robot->document;
  Diagnostic& diagnostic = findings.report(tag_name(model, document.root), "the robot has no link");
  if (!model.robot->name.written) {  // SML1102 does not report a robot that has nothing at all
    diagnostic.consequences.push_back(&rules::sml1102_robot_name_missing);
  }
  if (has_only_comments(document)) {
    diagnostic.severity = Severity::info;
    diagnostic.note("it has comments only, as a file that others include by default");
  }
  if (xml::View(document, document.root).attribute("xmlns:xacro") == nullptr) {
    if (!has_only_comments(document)) {
      diagnostic.help("add a link; a xacro whose macro nobody calls expands to such a robot");
    }
    return;
  }
  diagnostic.note("a xacro file that only defines macros makes an empty robot");
  diagnostic.help("expand the file that uses its macros");
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses a robot without links", "urdfdom, sdformat, run"},
    {&readers::mujoco, Effect::takes, "loads a robot without links", kRun},
    {&readers::drake, Effect::takes, "loads a robot without links", kRun},
};

}  // namespace

extern constinit const Rule sml1115_no_links{
    .id = "SML1115",
    .name = "no-links",
    .severity = Severity::error,
    .summary = "A robot has no link.",
    .remedy = "Add a link, or check whether this is the right file.",
    .sources = "4 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1115_no_links_file
