// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"
#include "lint/model_answers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3102_unknown_link_file {
namespace {

/// MARS 2 reads the name of the link from `link`, other readers from `name`; only one of them is
/// reported.
bool is_second_name(const AnnotationPlace& place) {
  if (place.section != "link" || place.key != "link") return false;
  const yaml::View name = place.entry.find("name");
  return name && !name.is_null();
}

void check(const LinkedModel& model, Findings& findings) {
  report_unknown(model, NameKind::link, findings, is_second_name);
  for (const Reference& one : findings.answers().doubtful_references()) {
    // The node may belong to another robot of the scene.
    const bool is_node = one.is_vague && one.kinds.contains(NameKind::node);
    if (is_node && !one.is_known() && is_slip(model, NameKind::link, one.name)) {
      report_unknown(model, one, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "dereferences a null pointer for a Joint6DOF, and ends with an assertion for a camera",
     "MARS smurf.cpp:277-283, CameraSensor.cpp:74-75, run",
     at("sensors/link").when(cases::kOnItsLink)},
    {&readers::mars, Effect::loses, "finds no such link", kRun, at("sensors")},
    {&readers::phobos, Effect::ignores, "does not look for it", kRun,
     at("sensors/link").when(cases::kOfOthers)},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run",
     at("sensors")},
    {&readers::phobos, Effect::ignores, "keeps the link of the URDF", kRun,
     when(cases::kKnownCollision)},
    {&readers::phobos, Effect::ignores, "keeps the link of the URDF", kRun, at("visuals")},
    {&readers::phobos, Effect::loses, "leaves the entry out", kRun, at("link/name")},
    {&readers::phobos, Effect::loses, "leaves the entry out", kRun, at("links/name")},
    {&readers::phobos, Effect::refuses, "stops with an assertion", kRun, at("collision/link")},
    {&readers::phobos, Effect::refuses, "stops with an assertion", kRun, at("collisions/link")},
};

}  // namespace

extern constinit const Rule sml3102_unknown_link{
    .id = "SML3102",
    .name = "unknown-link",
    .severity = Severity::error,
    .summary = "An annotation names a link that the URDF does not have.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3102_unknown_link_file
