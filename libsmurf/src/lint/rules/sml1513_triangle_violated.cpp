// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments) return;
    const auto& [low, middle, high] = *moments;
    if (!is_positive_definite(*moments) || triangle_excess(*moments) <= kImpossibleExcess) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " is not physically possible");
    diagnostic.caret = "principal moments " + format_rounded(low, 4) + ", " +
                       format_rounded(middle, 4) + ", " + format_rounded(high, 4) + ": " +
                       format_rounded(high, 4) + " > " + format_rounded(low, 4) + " + " +
                       format_rounded(middle, 4);
    diagnostic.notes.push_back("the largest moment can be at most the sum of the other two");
  });
}

}  // namespace

extern constinit const Rule sml1513_triangle_violated{
    .id = "SML1513",
    .name = "triangle-violated",
    .severity = Severity::error,
    .summary = "The principal moments of an inertia break the triangle inequality.",
    .why = "No mass distribution has such moments: sdformat reports an error, MuJoCo refuses the "
           "file, Drake puts a sphere of water in its place; ODE (MARS), DART and Pinocchio "
           "simulate nonsense.",
    .remedy = "Compute the inertia again, e.g. from the geometry and the mass.",
    .sources = "sdformat 12.3, MuJoCo 3.14 and ODE 0.16.2, executed; 62 links of the Tola/Corke "
               "dataset, all above 1 %.",
    .check_model = check};

}  // namespace smurf::rules
