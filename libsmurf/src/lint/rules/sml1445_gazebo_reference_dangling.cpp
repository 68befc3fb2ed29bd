// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "base/text/suggest.hpp"
#include "lint/model_answers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml1445_gazebo_reference_dangling_file {
namespace {

/// Without a reference the element applies to the model, so a misspelt attribute changes its
/// meaning.
void check_slip(xml::View gazebo, Findings& findings) {
  constexpr std::string_view kKnown[] = {"reference"};
  for (const xml::Attribute& one : gazebo.attributes()) {
    if (!nearest(one.name(), kKnown)) continue;
    Diagnostic& diagnostic =
        findings.report(one.name_span(), quoted(one.name()) + " is not an attribute of `gazebo`");
    diagnostic.note("Gazebo applies this element to the whole model");
    diagnostic.help("did you mean `reference`?");
    diagnostic.fixes.push_back({Applicability::unsafe,
                                {{one.name_span(), "reference"}},
                                Fix::NewName{gazebo.tag_span(), "reference"}});
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() == "gazebo" && gazebo.attribute("reference") == nullptr) {
      check_slip(gazebo, findings);
    }
  }
  for (const Reference& one : findings.answers().doubtful_references()) {
    const xml::View gazebo = element_of(model, one);
    if (!gazebo || gazebo.name() != "gazebo" || one.is_known()) continue;
    Diagnostic& diagnostic =
        findings.report(one.span, "no link and no joint is called " + quoted(one.name));
    diagnostic.note("Gazebo ignores this element and everything in it");
    auto near = findings.suggest(one.name, model.link_names.names());
    if (!near) near = findings.suggest(one.name, model.joint_names.names());
    if (!near) continue;
    diagnostic.help("did you mean " + quoted(*near) + "?");
    diagnostic.fixes.push_back({Applicability::unsafe, {{one.span, escape_xml(*near)}}});
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses,
     "ignores the element: friction, colours, sensors and limits in it never reach the simulation",
     kRun},
};

}  // namespace

extern constinit const Rule sml1445_gazebo_reference_dangling{
    .id = "SML1445",
    .name = "gazebo-reference-dangling",
    .severity = Severity::warning,
    .summary = "A gazebo element refers to neither a link nor a joint.",
    .remedy = "Correct the reference, or delete the element.",
    .sources = "7 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1445_gazebo_reference_dangling_file
