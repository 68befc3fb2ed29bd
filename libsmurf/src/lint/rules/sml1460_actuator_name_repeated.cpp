// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1460_actuator_name_repeated_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::map<std::string_view, Span> seen;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View transmission(model.robot->document, id);
    if (transmission.name() != "transmission") continue;
    const xml::View actuator = transmission.child("actuator");  // Drake reads the first only
    const xml::Attribute* name = actuator ? actuator.attribute("name") : nullptr;
    if (name == nullptr) continue;
    const auto [first, is_new] = seen.try_emplace(name->value(), name->value_span());
    if (is_new) continue;
    findings
        .report(name->value_span(), "another transmission has an actuator " + quoted(name->value()))
        .label(first->second, "the first one");
  }
}

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::refuses, "refuses two actuators of one name", kRun},
};

}  // namespace

extern constinit const Rule sml1460_actuator_name_repeated{
    .id = "SML1460",
    .name = "actuator-name-repeated",
    .severity = Severity::error,
    .summary = "Two transmissions have actuators of one name.",
    .remedy = "Give each actuator a name of its own, or delete the second transmission.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1460_actuator_name_repeated_file
