// SPDX-License-Identifier: BSD-3-Clause
#include "lint/name_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!are_links_named(model)) return;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.parent || joint.parent->empty()) return;
    Diagnostic* diagnostic = check_reference(model, NameKind::link, *joint.parent,
                                             joint.parent.span, subject(joint), findings);
    if (diagnostic != nullptr && *joint.parent == "world") {
      diagnostic->construct = "world";
      diagnostic->notes.push_back("only Drake knows a link `world` that is not declared");
      diagnostic->help = "declare it: `<link name=\"world\"/>`";
    }
  });
}

}  // namespace

extern constinit const Rule sml1201_parent_link_unknown{
    .id = "SML1201",
    .name = "parent-link-unknown",
    .severity = Severity::error,
    .summary = "A joint hangs below a link that the robot does not have.",
    .why = "Every reader refuses the file; only Drake knows a link `world` that nobody declared.",
    .remedy = "Correct the name, or declare the link.",
    .sources = "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14, Bullet, executed; urdf_model "
               "model.h:128.",
    .check_model = check};

}  // namespace smurf::rules
