// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1301_duplicate_name_file {
namespace {

// MuJoCo gives no name to a joint that is fixed.
constexpr Circumstance kOneIsFixed{"one of them is fixed"};

bool is_fixed(const urdf::Link&) { return false; }
bool is_fixed(const urdf::Joint& joint) { return joint.type == urdf::JointType::fixed; }

/// `names` has the first of each name. Works for links and joints.
template <class Elements, class Names>
void check_names(const Elements& elements, const Names& names, const char* what,
                 Findings& findings) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Field<std::string>& name = elements[i].name;
    if (!name || name->empty()) continue;
    const auto first = names.find(*name);
    if (*first == i) continue;
    Diagnostic& diagnostic =
        findings.report(name.span, "a second " + std::string(what) + " is named " + quoted(*name));
    diagnostic.label(elements[*first].name.span, "the first one");
    if (is_fixed(elements[i]) || is_fixed(elements[*first])) diagnostic.when(kOneIsFixed);
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  check_names(model.robot->links, model.link_names, "link", findings);
  check_names(model.robot->joints, model.joint_names, "joint", findings);
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file", "urdfdom, sdformat, MuJoCo, Bullet, run"},
    {&readers::mujoco, Effect::takes, "accepts joints of equal names", kRun,
     at("joint").since({3, 14})},
    {&readers::mujoco, Effect::takes, "gives fixed joints no name", "3.3.7, run",
     at("joint").when(kOneIsFixed).before({3, 14})},
};

}  // namespace

extern constinit const Rule sml1301_duplicate_name{
    .id = "SML1301",
    .name = "duplicate-name",
    .severity = Severity::error,
    .summary = "Two links, or two joints, have the same name.",
    .why = "urdf-loader uses the last one.",
    .remedy = "Rename one of them, with everything that refers to it.",
    .sources = "urdf-loader 0.13, executed.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1301_duplicate_name_file
