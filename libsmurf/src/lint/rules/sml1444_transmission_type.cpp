// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "base/text/suggest.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1444_transmission_type_file {
namespace {

/// The types of ros_control. Plugins add others, so only misspellings of these are reported.
constexpr std::string_view kTypes[] = {"transmission_interface/SimpleTransmission",
                                       "transmission_interface/DifferentialTransmission",
                                       "transmission_interface/FourBarLinkageTransmission",
                                       "SimpleTransmission",
                                       "DifferentialTransmission",
                                       "FourBarLinkageTransmission"};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View transmission(model.robot->document, id);
    if (transmission.name() != "transmission") continue;
    const xml::View type = transmission.child("type");
    if (!type) continue;
    constexpr int kSlip = 2;  // edits; HalfDifferentialTransmission is not a misspelling
    const auto* near =
        std::find_if(std::begin(kTypes), std::end(kTypes), [&](std::string_view known) {
          return edit_distance(type.text(), known, kSlip) <= kSlip;
        });
    if (near == std::end(kTypes) || *near == type.text()) continue;
    Diagnostic& diagnostic =
        findings.report(type.text_span(), "unknown transmission type " + quoted(type.text()));
    diagnostic.help("did you mean " + quoted(*near) + "?");
    diagnostic.fixes.push_back({Applicability::unsafe, {{type.text_span(), std::string(*near)}}});
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::loses,
     "ros_control finds no plugin of that name and does not load the transmission",
     "ros_control transmission_interface"},
    {&readers::drake, Effect::loses, "makes actuators only for simple transmissions", kRun},
};

}  // namespace

extern constinit const Rule sml1444_transmission_type{
    .id = "SML1444",
    .name = "transmission-type",
    .severity = Severity::warning,
    .summary = "The type of a transmission looks misspelt.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1444_transmission_type_file
