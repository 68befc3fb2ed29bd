// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || !joint.has_one_axis()) return;
    const Field<double>& lower = joint.limit->lower;
    const Field<double>& upper = joint.limit->upper;
    const bool is_readable = (lower || !lower.written) && (upper || !upper.written);
    if (!is_readable) return;
    const double low = lower.value_or(0);
    const double high = upper.value_or(0);
    if (low <= high) return;
    Diagnostic& diagnostic =
        findings.report(lower ? lower.span : upper.span,
                        "the lower limit " + format_number(low) + " of " + title(joint) +
                            " is above its upper limit " + format_number(high));
    if (!lower || !upper) {
      diagnostic.notes.push_back("urdfdom reads the absent limit as 0");
      return;
    }
    diagnostic.labels.push_back({upper.span, "the upper limit"});
    diagnostic.help = "swap the two values";
    const std::string low_text = format_number(low);
    diagnostic.fixes.push_back({Applicability::unsafe,
                                {{lower.span, format_number(high)}, {upper.span, low_text}}});
  });
}

}  // namespace

extern constinit const Rule sml1407_lower_gt_upper{
    .id = "SML1407",
    .name = "lower-gt-upper",
    .severity = Severity::error,
    .summary = "The lower limit of a joint is above its upper limit.",
    .why = "sdformat swaps the two, MuJoCo and Bullet ignore the limit, Drake aborts the process.",
    .remedy = "Swap the values, or correct the one that is wrong.",
    .sources = "sdformat 12.3 (parser_urdf.cc:3127), MuJoCo 3.14 and Bullet, executed; Drake "
               "joint.h:159.",
    .check_model = check};

}  // namespace smurf::rules
