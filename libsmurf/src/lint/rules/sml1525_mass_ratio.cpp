// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1525_mass_ratio_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const double largest = findings.tolerance();
  for (const LinkIndex index : model.tree.order) {
    const auto above = model.tree.parent_joint[to_size(index)];
    if (!above || !model.joint(*above).is_movable()) continue;
    const urdf::Link& link = model.link(index);
    const urdf::Link& parent = model.link(*model.tree.joint_parent[to_size(*above)]);
    if (!link.inertial || !parent.inertial) continue;
    const double mass = link.inertial->mass.value_or(0);
    const double other = parent.inertial->mass.value_or(0);
    constexpr double kTiny = 1e-6;  // kg; other rules report such masses
    if (mass <= kTiny || other <= kTiny || (mass <= largest * other && other <= largest * mass)) {
      continue;
    }
    Diagnostic& diagnostic =
        findings.report(link.inertial->mass.span,
                        title(link) + (mass > other ? " is heavier" : " is lighter") + " than " +
                            title(parent) + ", which carries it, by a factor of " +
                            format_number(std::round(std::max(mass / other, other / mass))));
    diagnostic.label(parent.inertial->mass.span, "the other mass");
  }
}

}  // namespace

extern constinit const Rule sml1525_mass_ratio{
    .id = "SML1525",
    .name = "mass-ratio",
    .severity = Severity::info,
    .summary = "A link is a thousand times heavier or lighter than the link it carries.",
    .why = "Iterative solvers converge slowly at such ratios: joints drift apart.",
    .remedy =
        "Check the units of both masses; small parts can be merged into the link that they are "
        "fixed to.",
    .sources = "ODE manual, stability; Bullet user manual, mass ratios.",
    .check_model = check,
    .tolerance = {.value = 1000, .meaning = "how many times as heavy a link may be"},
    .about = About::robot};

}  // namespace smurf::rules::sml1525_mass_ratio_file
