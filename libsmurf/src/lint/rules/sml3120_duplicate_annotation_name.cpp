// SPDX-License-Identifier: BSD-3-Clause
#include <unordered_map>

#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

template <class Entries>
void check_entries(const Entries& entries, std::string_view kind, Findings& findings) {
  std::unordered_map<std::string_view, Span> first;
  for (const auto& entry : entries) {
    if (!entry.name) continue;
    const auto [found, is_new] = first.emplace(*entry.name, entry.name.span);
    if (is_new) continue;
    Diagnostic& diagnostic = findings.report(
        entry.name.span, "there is another " + std::string(kind) + " " + quoted(*entry.name));
    diagnostic.labels.push_back({found->second, "the first one"});
    diagnostic.notes.push_back("in MARS the name leads to the last one");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  check_entries(model.annotations.motors, "motor", findings);
  check_entries(model.annotations.sensors, "sensor", findings);
  check_entries(model.annotations.controllers, "controller", findings);
  check_entries(model.annotations.poses, "joint pose", findings);
}

}  // namespace

extern constinit const Rule sml3120_duplicate_annotation_name{
    .id = "SML3120",
    .name = "duplicate-annotation-name",
    .severity = Severity::warning,
    .summary = "Two motors, sensors, controllers or joint poses have one name.",
    .why = "MARS creates both, but a name leads to the last one only: controllers, poses "
           "and mimicking motors never reach the first.",
    .remedy = "Rename one of them.",
    .sources = "MARS smurf.cpp:262, 326.",
    .check_model = check};

}  // namespace smurf::rules
