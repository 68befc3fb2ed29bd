// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"
#include "lint/name_queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1306_reference_whitespace_file {
namespace {

constexpr Circumstance kNothingElse{"nothing else"};

void check(const LinkedModel& model, Findings& findings) {
  for_each_name(model, [&](std::string_view kind, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::blank) return;
    Diagnostic& diagnostic =
        findings.report(name.span, "a space is part of the name " + quoted(*name));
    const std::string_view meant = trimmed(*name);
    if (meant.empty()) {
      diagnostic.when(kNothingElse);
      return;
    }
    const NameTable& others = kind == "link" ? model.link_names : model.joint_names;
    if (others.contains(meant)) return;
    const Span robot = model.robot->document.view().span();
    diagnostic.fixes.push_back({Applicability::unsafe,
                                {{name.span, escape_xml(meant)}},
                                Fix::NewName{robot, std::string(kind) + " " + std::string(meant)}});
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "keeps the name with the space", kRun, at("joint/@name")},
    {&readers::drake, Effect::takes, "keeps the name with the space", kRun, at("joint/@name")},
    {&readers::urdf, Effect::refuses,
     "finds no link with that name, because the space is part of it", "urdfdom, run"},
    {&readers::urdfdom, Effect::changes,
     "does not look for the leading joint, so the joint moves freely", kRun, at("mimic")},
    {&readers::urdfdom, Effect::takes, "keeps the space in the name", kRun, at("joint/@name")},
    {&readers::gazebo, Effect::takes, "merges the two into one link without a joint", kRun,
     at("joint/@name").when(kNothingElse, kInFixed)},
    {&readers::gazebo, Effect::refuses, "refuses a joint without a name", kRun,
     at("joint/@name").when(kNothingElse)},
    {&readers::mujoco, Effect::takes, "keeps the space in the name", kRun, at("joint/@name")},
};

}  // namespace

extern constinit const Rule sml1306_reference_whitespace{
    .id = "SML1306",
    .name = "reference-whitespace",
    .severity = Severity::error,
    .summary = "A name or a reference to one begins or ends with a space.",
    .why = "Names are compared byte by byte.",
    .remedy = "Delete the space.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1306_reference_whitespace_file
