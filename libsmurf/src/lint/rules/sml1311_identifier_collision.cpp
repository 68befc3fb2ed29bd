// SPDX-License-Identifier: BSD-3-Clause
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1311_identifier_collision_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const auto& [kind, first, second] : name_collisions(model, as_identifier)) {
    Diagnostic& diagnostic = findings.report(
        second->span, quoted(**second) + " and " + quoted(**first) + " become the same name " +
                          quoted(as_identifier(**first)) + " in Isaac and USD");
    diagnostic.label(first->span, "the other " + std::string(kind));
  }
}

}  // namespace

extern constinit const Rule sml1311_identifier_collision{
    .id = "SML1311",
    .name = "identifier-collision",
    .severity = Severity::warning,
    .summary = "Two names become the same where only identifiers are allowed.",
    .why =
        "USD replaces every character except letters, digits and underscores by `_`: one of the two overwrites the other.",
    .remedy = "Rename one of them.",
    .sources = "Isaac importer PathUtils.cpp:356-369.",
    .check_model = check};

}  // namespace smurf::rules::sml1311_identifier_collision_file
