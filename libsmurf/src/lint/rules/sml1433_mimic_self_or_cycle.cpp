// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mimic_queries.hpp"

namespace smurf::rules::sml1433_mimic_self_or_cycle_file {
namespace {

constexpr Circumstance kCycle{"cycle"};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const auto count = static_cast<std::uint32_t>(model.robot->joints.size());
  std::vector<std::uint32_t> seen_from(count, count);
  for (std::uint32_t start = 0; start < count; ++start) {
    std::optional<std::uint32_t> at = start;
    while (at && seen_from[*at] == count) {
      seen_from[*at] = start;
      at = mimic_leader(model, *at);
    }
    if (!at || seen_from[*at] != start || !mimic_leader(model, *at)) continue;
    const urdf::Joint& joint = model.robot->joints[*at];
    const bool is_itself = *joint.mimic->joint == joint.name.value_or("");
    Diagnostic& diagnostic = findings.report(
        joint.mimic->joint.span,
        title(joint) + (is_itself ? " mimics itself" : " mimics itself through other joints"));
    if (!is_itself) diagnostic.when(kCycle);
  }
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::ignores, "ignores mimic", kRun},
    {&readers::ros, Effect::loses, "MoveIt drops every mimic of the robot",
     "MoveIt robot_model.cpp:426"},
    {&readers::mujoco, Effect::changes, "builds contradicting constraints from a cycle", kRun,
     when(kCycle)},
    {&readers::mujoco, Effect::refuses, "refuses a joint that mimics itself", kRun},
    {&readers::drake, Effect::changes, "couples the joints of a cycle", kRun, when(kCycle)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
    {&readers::gazebo, Effect::takes, "leaves mimic out", kRun, before({14, 0})},
    {&readers::dart, Effect::changes, "keeps a joint that follows itself", kRun},
};

}  // namespace

extern constinit const Rule sml1433_mimic_self_or_cycle{.id = "SML1433",
                                                        .name = "mimic-self-or-cycle",
                                                        .severity = Severity::error,
                                                        .summary = "Mimic joints form a cycle.",
                                                        .why = "urdf-loader refuses the file.",
                                                        .remedy =
                                                            "Let one joint of the cycle lead.",
                                                        .sources = "urdf-loader 0.13, executed.",
                                                        .check_model = check,
                                                        .facts = kFacts};

}  // namespace smurf::rules::sml1433_mimic_self_or_cycle_file
