// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"
#include "lint/mimic_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1434_mimic_chain_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const std::vector<bool> is_endless = endless_mimics(model);
  for (std::uint32_t i = 0; i < model.robot->joints.size(); ++i) {
    const auto leader = mimic_leader(model, i);
    if (!leader || is_endless[i] || !mimic_leader(model, *leader)) continue;
    const urdf::Joint& joint = model.robot->joints[i];
    const urdf::Joint& middle = model.robot->joints[*leader];
    const urdf::Mimic& own = *joint.mimic;
    const urdf::Mimic& next = *middle.mimic;
    Diagnostic& diagnostic =
        findings.report(own.joint.span, title(joint) + " mimics " + title(middle) +
                                            ", which mimics " + quoted(*next.joint));
    diagnostic.label(next.joint.span, "the next joint of the chain");
    const double factor = own.multiplier.value_or(1);
    diagnostic.help("mimic " + quoted(*next.joint) + " with the multiplier " +
                    format_rounded(factor * next.multiplier.value_or(1)) + " and the offset " +
                    format_rounded(factor * next.offset.value_or(0) + own.offset.value_or(0)));
  }
}

}  // namespace

extern constinit const Rule sml1434_mimic_chain{
    .id = "SML1434",
    .name = "mimic-chain",
    .severity = Severity::warning,
    .summary = "A joint mimics a joint that itself mimics another.",
    .why =
        "Not every reader follows the chain to its end: some use the commanded position of the middle joint, which does not exist.",
    .remedy =
        "Let it mimic the joint at the end of the chain. Its multiplier is the product of both; the offset of the middle joint is multiplied, too.",
    .sources = "urdf-loader 0.13 and MuJoCo, executed; Pinocchio model.cpp:213.",
    .check_model = check};

}  // namespace smurf::rules::sml1434_mimic_chain_file
