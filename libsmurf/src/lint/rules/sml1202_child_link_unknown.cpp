// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/name_queries.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const urdf::Link* unnamed = link_without_name(model);
  for (const Reference& one : findings.doubtful_references()) {
    const xml::View child = element_of(model, one);
    if (!child || child.name() != "child") continue;
    withhold_fix(check_link_of_joint(model, one, subject_of(child.parent()), unnamed, findings),
                 other_link(child));
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file",
     "urdfdom model.h:128; MuJoCo, Bullet, run"},
};

}  // namespace

extern constinit const Rule sml1202_child_link_unknown{
    .id = "SML1202",
    .name = "child-link-unknown",
    .severity = Severity::error,
    .summary = "The child of a joint is a link that the robot does not have.",
    .why = "urdf-loader draws half a robot.",
    .remedy = "Correct the name, or declare the link.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules
