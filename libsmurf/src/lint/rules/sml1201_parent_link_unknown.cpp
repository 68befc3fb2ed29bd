// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/name_queries.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const urdf::Link* unnamed = link_without_name(model);
  for (const Reference& one : findings.doubtful_references()) {
    const xml::View parent = element_of(model, one);
    if (!parent || parent.name() != "parent") continue;
    Diagnostic* diagnostic =
        check_link_of_joint(model, one, subject_of(parent.parent()), unnamed, findings);
    if (diagnostic != nullptr && one.name == "world") {
      diagnostic->construct = "drake-world";
      diagnostic->notes.push_back(
          "only Drake has a link `world` without a declaration; check files for Drake with "
          "`--target drake`");
      diagnostic->help = "declare it: `<link name=\"world\"/>`";
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::breaks, "keeps a joint without a parent", kRun},
    {&readers::urdf, Effect::refuses, "refuses the file",
     "urdfdom model.h:128; MuJoCo, Bullet, run"},
    {&readers::drake, Effect::takes, "has an implicit link `world`",
     "Drake detail_urdf_parser.cc:518", "#drake-world"},
};

}  // namespace

extern constinit const Rule sml1201_parent_link_unknown{
    .id = "SML1201",
    .name = "parent-link-unknown",
    .severity = Severity::error,
    .summary = "The parent of a joint is a link that the robot does not have.",
    .remedy = "Correct the name, or declare the link.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules
