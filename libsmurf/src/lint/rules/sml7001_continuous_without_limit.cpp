// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7001_continuous_without_limit_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.type != urdf::JointType::continuous || joint.limit) return;
    findings.report(joint.type_name.span, "continuous " + title(joint) + " has no `limit`")
        .help("add `<limit effort=\"...\" velocity=\"...\"/>`");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars2, Effect::crashes, "dereferences a null pointer",
     "envire_smurf_loader Model.cpp:636-641"},
    {&readers::envire, Effect::crashes, "dereferences a null pointer",
     "rock-cpp/smurf Robot.cpp:233-241"},
};

}  // namespace

extern constinit const Rule sml7001_continuous_without_limit{
    .id = "SML7001",
    .name = "continuous-without-limit",
    .severity = Severity::error,
    .summary = "A continuous joint has no limit element.",
    .why = "URDF does not require one.",
    .remedy = "Add a limit with effort and velocity.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7001_continuous_without_limit_file
