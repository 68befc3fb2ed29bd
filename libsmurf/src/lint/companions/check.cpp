// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/check.hpp"

#include "smurf/lint_companions.hpp"

namespace smurf {
namespace {

struct Row {
  const Rule* rule;
  const CompanionCheck* check;
};
constexpr Row kRows[] = {
#define SMURF_RULE(name) {&rules::name, &companion_checks::name},
#include "base/findings/companion_rules.def"
#undef SMURF_RULE
};

}  // namespace

void lint_companions(const LinkedModel& model, const Companions& companions,
                     const RuleSelection& selection, DiagnosticSink& sink) {
  DoubtfulReferences references(&model);
  for (const Row& row : kRows) {
    if (!selection.is_enabled(*row.rule)) continue;
    Findings findings(*row.rule, selection.tolerance_of(*row.rule), sink, references);
    (*row.check)(model, companions, findings);
  }
}

}  // namespace smurf
