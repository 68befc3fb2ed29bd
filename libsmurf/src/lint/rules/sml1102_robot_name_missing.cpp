// SPDX-License-Identifier: BSD-3-Clause
#include "base/edits.hpp"
#include "base/path.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const Field<std::string>& name = model.robot->name;
  if (name.written && !name->empty()) return;
  const Span tag = tag_name(model, model.robot->document.root);
  if (!name.written && has_slip(model, model.robot->document.root, "name")) return;
  Diagnostic& diagnostic =
      findings.report(tag, name.written ? "the robot has an empty name" : "the robot has no name");
  const std::string stem(path::stem(model.urdf_path));
  if (stem.empty()) return;
  const Edit edit =
      name.written ? Edit{name.span, escape_xml(stem)}
                   : Edit{{tag.source, tag.end, tag.end}, " name=\"" + escape_xml(stem) + "\""};
  diagnostic.help = "name it, e.g. " + quoted(stem) + " like the file";
  diagnostic.fixes.push_back({Applicability::unsafe, {edit}});
}

}  // namespace

extern constinit const Rule sml1102_robot_name_missing{
    .id = "SML1102",
    .name = "robot-name-missing",
    .severity = Severity::error,
    .summary = "The robot has no name, or an empty one.",
    .why = "urdfdom, sdformat and Bullet refuse a robot without name, sdformat an empty one as "
           "well.",
    .remedy = "Give the robot element a name.",
    .sources = "urdfdom 3.0.1 model.cpp:115, sdformat 12.3 and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
