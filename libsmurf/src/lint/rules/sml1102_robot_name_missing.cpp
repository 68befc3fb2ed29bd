// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1102_robot_name_missing_file {
namespace {

constexpr Circumstance kEmpty{"empty"};
constexpr Circumstance kBlank{"blanks"};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const Field<std::string>& name = model.robot->name;
  if (name.written && !trimmed(*name).empty()) return;
  const xml::View root(model.robot->document, model.robot->document.root);
  // A robot of macros only, or a file with nothing but comments: SML1115.
  const bool is_of_macros = root.attribute("xmlns:xacro") != nullptr && model.robot->links.empty();
  if (!name.written && (is_of_macros || has_only_comments(model.robot->document))) return;
  const Span tag = tag_name(model, model.robot->document.root);
  if (!name.written && is_slip(model, model.robot->document.root, "name", findings)) return;
  Diagnostic& diagnostic =
      findings.report(tag, name.written ? "the robot has an empty name" : "the robot has no name");
  if (name.written) diagnostic.when(kEmpty);
  if (name.written && !name->empty()) diagnostic.when(kBlank);
  const std::string stem(path::stem(model.urdf_path));
  if (stem.empty()) return;
  const Edit edit =
      name.written ? Edit{name.span, escape_xml(stem)}
                   : Edit{{tag.source, tag.end, tag.end}, " name=\"" + escape_xml(stem) + "\""};
  diagnostic.help("name it, e.g. " + quoted(stem) + " like the file");
  diagnostic.fixes.push_back({Applicability::unsafe, {edit}});
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "accepts an empty name", kRun, when(kEmpty)},
    {&readers::urdfdom, Effect::refuses, "refuses a robot without a name",
     "urdfdom model.cpp:115, run"},
    {&readers::pybullet, Effect::takes, "takes an empty name", kRun, when(kEmpty)},
    {&readers::pybullet, Effect::refuses, "refuses a robot without a name",
     "Bullet UrdfParser.cpp, run"},
    {&readers::gazebo, Effect::refuses, "refuses an empty name", kRun, when(kEmpty)},
    {&readers::mujoco, Effect::takes, "needs no name", kRun},
    {&readers::drake, Effect::takes, "keeps a name of blanks", kRun, when(kBlank)},
    {&readers::drake, Effect::crashes, "ends the process at an empty name", kRun, when(kEmpty)},
    {&readers::drake, Effect::refuses, "refuses a robot without a name, unless the caller names it",
     kRun},
};

}  // namespace

extern constinit const Rule sml1102_robot_name_missing{
    .id = "SML1102",
    .name = "robot-name-missing",
    .severity = Severity::error,
    .summary = "The robot has no name, or an empty one.",
    .remedy = "Give the robot element a name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1102_robot_name_missing_file
