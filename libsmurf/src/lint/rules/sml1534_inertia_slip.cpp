// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"
#include "lint/exact_slip.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1534_inertia_slip_file {
namespace {

void check_link(const LinkedModel& model, const urdf::Link& link, Findings& findings) {
  const std::optional<ExactSlip> slip = exact_slip(link, findings.answers());
  if (!slip) return;
  Diagnostic& finding =
      findings.report(inertia_place(model, *link.inertial),
                      "the inertia of " + title(link) + " fits its shape " + slip->message);
  finding.caret = format_rounded(100 * slip->off, 2) + " % off as it stands";
  finding.help(slip->help);
  if (auto fix = fix_of(*link.inertial, slip->tensor)) finding.fixes.push_back(std::move(*fix));
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) { check_link(model, link, findings); });
}

}  // namespace

extern constinit const Rule sml1534_inertia_slip{
    .id = "SML1534",
    .name = "inertia-slip",
    .severity = Severity::warning,
    .summary = "An inertia is exactly that of the shape, apart from a known mistake.",
    .why = "CAD programs print products with either sign, and tensors about the origin as well as "
           "about the centre of mass.",
    .remedy = "Change the signs of the products, or take the tensor about the centre of mass.",
    .sources =
        "Reported where the tensor is more than 10 % off and less than 3 % after the change; "
        "none of 367 links with a closed mesh of public robots.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1534_inertia_slip_file
