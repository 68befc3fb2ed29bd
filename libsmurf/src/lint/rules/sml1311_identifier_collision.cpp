// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1311_identifier_collision_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const auto& [kind, first, second] : name_collisions(model, as_identifier)) {
    Diagnostic& diagnostic = findings.report(
        second->span, quoted(**second) + " and " + quoted(**first) + " become the same name " +
                          quoted(as_identifier(**first)) + " in USD, and in Isaac Sim before 6");
    diagnostic.label(first->span, "the other " + std::string(kind));
  }
}

constexpr Fact kFacts[] = {
    {&readers::isaac, Effect::loses, "makes one name of the two", "PathUtils.cpp:356-369",
     before({6, 0})},
    {&readers::isaac, Effect::changes, "renames both, to different names", kRun},
};

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
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1311_identifier_collision_file
