// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1312_case_only_difference_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const auto& [kind, first, second] : name_collisions(model, path::to_lower)) {
    Diagnostic& diagnostic =
        findings.report(second->span, "the " + std::string(kind) + "s " + quoted(**first) +
                                          " and " + quoted(**second) + " differ only in case");
    diagnostic.label(first->span, "the other " + std::string(kind));
  }
}

}  // namespace

extern constinit const Rule sml1312_case_only_difference{
    .id = "SML1312",
    .name = "case-only-difference",
    .severity = Severity::warning,
    .summary = "Two names differ only in case.",
    .why =
        "Files and prims made from them overwrite one another on systems that ignore case (Windows, macOS), and people confuse them.",
    .remedy = "Rename one of them.",
    .sources = "URDF names are compared byte by byte in every reader that was executed.",
    .check_model = check};

}  // namespace smurf::rules::sml1312_case_only_difference_file
