// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"
#include "lint/model_answers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3108_misspelt_mechanism_name_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Reference& one : findings.answers().doubtful_references()) {
    const bool is_node = one.kinds.contains(NameKind::node);
    if (!one.is_vague || is_node || !is_slip(model, one.kind, one.name)) continue;
    report_unknown(model, one, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses,
     "looks the names up in the URDF, and stops with an exception",
     "Phobos io/hyrodyn.py, core/robot.py:352-360, run"},
};

}  // namespace

extern constinit const Rule sml3108_misspelt_mechanism_name{
    .id = "SML3108",
    .name = "misspelt-mechanism-name",
    .severity = Severity::warning,
    .summary =
        "A submechanism or exoskeleton has a name that resembles a joint or link of the URDF.",
    .why =
        "Names that resemble nothing are not reported: the joints of a floating base need not be "
        "in the URDF.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3108_misspelt_mechanism_name_file
