// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/readers.hpp"
#include "lint/name_queries.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules {
namespace {

bool has_motor(const LinkedModel& model, xml::View joint) {
  const xml::Attribute* name = joint.attribute("name");
  const std::vector<Motor>& motors = model.annotations.motors;
  return name != nullptr && std::any_of(motors.begin(), motors.end(), [&](const Motor& motor) {
           return motor.joint.value_or("") == name->value();
         });
}

void check(const LinkedModel& model, Findings& findings) {
  const urdf::Link* unnamed = link_without_name(model);
  for (const Reference& one : findings.doubtful_references()) {
    const xml::View end = element_of(model, one);
    if (!end || (end.name() != "parent" && end.name() != "child")) continue;
    Diagnostic* diagnostic =
        check_link_of_joint(model, one, subject_of(end.parent()), unnamed, findings);
    withhold_fix(diagnostic, other_link(end));
    if (diagnostic != nullptr && has_motor(model, end.parent())) diagnostic->construct = "driven";
    if (diagnostic != nullptr && end.name() == "parent" && one.name == "world") {
      diagnostic->construct += "#drake-world";
      diagnostic->note(
          "only Drake has a link `world` without a declaration; check files for Drake with "
          "`--target drake`");
      diagnostic->help("declare it: `<link name=\"world\"/>`");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses, "stops with an UnboundLocalError at the motor of the joint",
     "Phobos io/smurfrobot.py:211-215, run", "/parent/@link/#driven"},
    {&readers::phobos, Effect::breaks, "keeps a joint without a parent", kRun, "/parent/"},
    {&readers::urdf, Effect::refuses, "refuses the file",
     "urdfdom model.h:128; MuJoCo, Bullet, run"},
    {&readers::drake, Effect::takes, "has an implicit link `world`",
     "Drake detail_urdf_parser.cc:518", "#drake-world"},
};
constexpr std::string_view kFormer[] = {"SML1202", "parent-link-unknown", "child-link-unknown"};

}  // namespace

extern constinit const Rule sml1201_unknown_link_of_joint{
    .id = "SML1201",
    .name = "unknown-link-of-joint",
    .severity = Severity::error,
    .summary = "The parent or child of a joint is a link that the robot does not have.",
    .why = "urdf-loader draws half a robot.",
    .remedy = "Correct the name, or declare the link.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true,
    .former = kFormer};

}  // namespace smurf::rules
