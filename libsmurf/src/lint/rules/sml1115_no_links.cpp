// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !model.robot->links.empty()) return;
  findings.report(tag_name(model, model.robot->document.root), "the robot has no link");
}

}  // namespace

extern constinit const Rule sml1115_no_links{
    .id = "SML1115",
    .name = "no-links",
    .severity = Severity::error,
    .summary = "A robot has no link.",
    .why = "urdfdom, sdformat and Bullet refuse the file.",
    .remedy = "Add a link, or name the right file.",
    .sources = "urdfdom 3.0.1, sdformat 12.3 and Bullet, executed; 4 of 322 files of the "
               "Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules
