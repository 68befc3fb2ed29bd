// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/numbers/numbers.hpp"
#include "lint/odd_siblings.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1530_unlike_siblings_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const OddSibling& odd : odd_siblings(model, findings.tolerance())) {
    const bool is_mass = odd.of_mass > findings.tolerance();
    const urdf::Inertial& own = *odd.link->inertial;
    const urdf::Inertial& usual = *odd.usual->inertial;
    findings
        .report(is_mass ? own.mass.span : inertia_place(model, own),
                title(*odd.link) + " differs from " + std::to_string(odd.others) +
                    " others like it: its " + (is_mass ? "mass" : "inertia") + " by a factor of " +
                    format_rounded(odd.worst, 3))
        .label(is_mass ? usual.mass.span : inertia_place(model, usual), "one of the others");
  }
}

}  // namespace

extern constinit const Rule sml1530_unlike_siblings{
    .id = "SML1530",
    .name = "unlike-siblings",
    .severity = Severity::warning,
    .summary = "One of several links of a kind has another mass or inertia than the others.",
    .why = "Wheels, fingers and legs of a robot are copies of one part. If all but one are equal, "
           "the numbers of that one were changed by mistake or not updated.",
    .remedy = "Copy the inertial of one of the others.",
    .sources = "A public robot with four wheels, one of which has a hundredth of the inertia.",
    .check_model = check,
    .tolerance = {.value = kOddFactor,
                  .meaning = "the factor by which one may differ from the others"},
    .about = About::robot};

}  // namespace smurf::rules::sml1530_unlike_siblings_file
