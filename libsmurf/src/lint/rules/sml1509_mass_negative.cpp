// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || !link.inertial->mass || *link.inertial->mass >= 0) return;
    findings.report(link.inertial->mass.span, "the mass of " + title(link) + " is " +
                                                  format_number(*link.inertial->mass) + " kg");
  });
}

}  // namespace

extern constinit const Rule sml1509_mass_negative{
    .id = "SML1509",
    .name = "mass-negative",
    .severity = Severity::error,
    .summary = "A link has a negative mass.",
    .why = "It is impossible; MuJoCo refuses the file, Drake puts a sphere of water in its place, "
           "urdfdom and Bullet accept it.",
    .remedy = "Correct the sign.",
    .sources = "MuJoCo 3.14, executed; Drake detail_common.cc:446-515.",
    .check_model = check};

}  // namespace smurf::rules
