// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (link.name && link.name->empty()) {
      findings.report(tag_name(model, link.element), "a link has an empty name");
    }
  });
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.name && joint.name->empty()) {
      findings.report(tag_name(model, joint.element), "a joint has an empty name");
    }
  });
}

}  // namespace

extern constinit const Rule sml1305_name_empty{
    .id = "SML1305",
    .name = "name-empty",
    .severity = Severity::error,
    .summary = "A link or joint has an empty name.",
    .why = "urdfdom keeps a link without name and then reports two roots; nothing can refer to "
           "it.",
    .remedy = "Give it a name.",
    .sources = "urdfdom 3.0.1 and MuJoCo 3.14, executed.",
    .check_model = check};

}  // namespace smurf::rules
