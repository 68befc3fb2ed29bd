// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3513_srdf_state_beyond_limit_file {
namespace {

void check_value(const srdf::GroupState& state, const srdf::StateJoint& one,
                 const urdf::Joint& joint, Findings& findings) {
  const bool has_range =
      joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
  const auto read = one.value ? parse_number(*one.value) : std::nullopt;
  if (!has_range || !joint.limit || !read) return;
  const double value = *read;
  if (joint.mimic && joint.mimic->joint) return;  // SML3514
  const double lower = joint.limit->lower.value_or(0);
  const double upper = joint.limit->upper.value_or(0);
  const bool is_unread = (joint.limit->lower.written && !joint.limit->lower) ||
                         (joint.limit->upper.written && !joint.limit->upper);
  const double slack = findings.tolerance();
  if (is_unread || lower > upper || (value >= lower - slack && value <= upper + slack)) return;
  findings
      .report(one.value.span, title_of("state", state.name) + " sets the joint " +
                                  quoted(*one.name) + " to " + format_rounded(value) +
                                  ", beyond its limits " + format_rounded(lower) + " to " +
                                  format_rounded(upper))
      .label(joint.name.span, "the joint is defined here")
      .help("write a value within the limits");
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::GroupState& state : srdf.states) {
      for (const srdf::StateJoint& one : state.joints) {
        const urdf::Joint* joint = one.name ? model.find_joint(*one.name) : nullptr;
        if (joint != nullptr) check_value(state, one, *joint, findings);
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::changes, "plans no motion to the state: it is out of bounds",
     "moveit2 robot_state.cpp satisfiesBounds"},
};

}  // namespace

extern constinit const Rule sml3513_srdf_state_beyond_limit{
    .id = "SML3513",
    .name = "srdf-state-beyond-limit",
    .severity = Severity::warning,
    .summary = "A group state sets a joint to a position beyond its limits.",
    .remedy = "Write a value within the limits of the joint.",
    .check_companions = check,
    .tolerance = {1e-3, "rad or m", "how far the position may be beyond a limit"},
    .facts = kFacts};

}  // namespace smurf::rules::sml3513_srdf_state_beyond_limit_file
