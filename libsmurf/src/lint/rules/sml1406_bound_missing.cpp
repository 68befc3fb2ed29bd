// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules::sml1406_bound_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool needs_bounds =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (!needs_bounds || !joint.limit || is_empty_limit(model, joint)) return;
    // A misspelt bound is reported at its place (SML1107).
    const auto is_there = [&](const Field<double>& bound, std::string_view name) {
      return bound.written || is_slip(model, joint.limit->element, name, findings);
    };
    const bool has_lower = is_there(joint.limit->lower, "lower");
    const bool has_upper = is_there(joint.limit->upper, "upper");
    if (has_lower && has_upper) return;
    const std::string_view missing = has_lower ? "upper" : has_upper ? "lower" : "";
    Diagnostic& diagnostic =
        findings.report(tag_name(model, joint.limit->element),
                        "the limit of " + title(joint) + " has no " +
                            (missing.empty() ? "`lower` and no `upper`" : quoted(missing)));
    diagnostic.note("urdfdom reads 0, MuJoCo and Drake no limit, Bullet -1 as upper");
    // Absent, both are 0 to urdfdom: the joint is locked there and free elsewhere.
    if (missing.empty()) diagnostic.severity = Severity::warning;
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "reads an absent limit as 0", kRun},
    {&readers::mars, Effect::ignores, "reads no limits from the URDF", "MARS smurf.cpp:902-910"},
    {&readers::pybullet, Effect::changes,
     "reads an absent lower limit as 0, an absent upper one as -1",
     "Bullet UrdfParser.cpp:1452, run"},
    {&readers::mujoco, Effect::changes, "lets the joint move without limit", kRun},
    {&readers::drake, Effect::changes, "reads infinity", kRun},
};

}  // namespace

extern constinit const Rule sml1406_bound_missing{
    .id = "SML1406",
    .name = "bound-missing",
    .severity = Severity::error,
    .summary = "A revolute or prismatic joint has only one of its position limits, or none.",
    .remedy = "Write both limits, or make the joint continuous.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1406_bound_missing_file
