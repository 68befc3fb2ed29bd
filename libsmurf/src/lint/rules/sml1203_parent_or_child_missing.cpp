// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/mimic_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1203_parent_or_child_missing_file {
namespace {

constexpr Circumstance kEmpty{"empty"};

void check_end(const LinkedModel& model, const urdf::Joint& joint, std::string_view end,
               const Field<std::string>& name, const std::set<std::string_view>& followed,
               Findings& findings) {
  if (name && !name->empty()) return;
  const xml::View element(model.robot->document, joint.element);
  const xml::View child = element.child(end);
  const xml::ElementId holder = child ? child.id() : joint.element;
  if (is_slip(model, holder, child ? "link" : end, findings)) return;
  Diagnostic& diagnostic = findings.report(child ? child.name_span() : name_place(model, joint),
                                           title(joint) + " has no " + std::string(end) + " link");
  const std::string text(child ? trimmed(child.text()) : std::string_view());
  if (!text.empty()) {
    diagnostic.help("this is the way of SDF; in a URDF, write `<" + std::string(end) + " link=\"" +
                    text + "\"/>`");
  }
  if (name) diagnostic.when(kEmpty);
  if (joint.name && followed.contains(*joint.name)) diagnostic.when(kFollowed);
}

void check(const LinkedModel& model, Findings& findings) {
  const std::set<std::string_view> followed = followed_joints(model);
  for_each_joint(model, [&](const urdf::Joint& joint) {
    check_end(model, joint, "parent", joint.parent, followed, findings);
    check_end(model, joint, "child", joint.child, followed, findings);
  });
}

constexpr Fact kFacts[] = {
    drake_misses_leader(when(kEmpty, kFollowed)),
    {&readers::drake, Effect::loses, "leaves out the joint", kRun, when(kEmpty)},
    {&readers::urdf, Effect::refuses, "refuses the file", "urdfdom, MuJoCo, Bullet, Drake, run"},
};

}  // namespace

extern constinit const Rule sml1203_parent_or_child_missing{
    .id = "SML1203",
    .name = "parent-or-child-missing",
    .severity = Severity::error,
    .summary = "A joint lacks its parent or its child.",
    .why = "Every reader refuses the file.",
    .remedy = "Add `<parent link=\"...\"/>` and `<child link=\"...\"/>`.",
    .sources = "urdfdom, sdformat, MuJoCo and Bullet, executed.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1203_parent_or_child_missing_file
