// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/sdformat_losses.hpp"

namespace smurf::rules::sml1454_massless_sum_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const MasslessSum& sum : massless_sums_of_sdformat(model)) {
    const urdf::Link& link = model.link(sum.link);
    const urdf::Link& parent = model.link(sum.parent);
    const bool is_written = link.inertial && link.inertial->mass.written;
    Diagnostic& diagnostic = findings.report(
        is_written ? link.inertial->mass.span : name_place(model, link),
        title(link) + " and " + title(parent) + ", to which it is fixed, have no mass together");
    diagnostic.label(name_place(model, parent), "fixed to this link");
    diagnostic.help("delete the `inertial` of " + title(link) + ", or write a mass");
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::refuses,
     "divides 0 by 0 for the centre of mass, and refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1454_massless_sum{
    .id = "SML1454",
    .name = "massless-sum",
    .severity = Severity::warning,
    .summary =
        "An inertial without mass belongs to a link that is fixed to another link without mass.",
    .why =
        "The conversion to SDF merges the two and computes their centre of mass, even if both are fixed to a heavy body.",
    .remedy = "Delete the inertials of links that are only frames, or write a small mass.",
    .sources = "XBot-L of humanoid-gym, the UR5 of cliport.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1454_massless_sum_file
