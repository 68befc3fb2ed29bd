// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

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
    if (high == 0 && low == 0) return;  // all zero is another defect
    if (is_positive_definite(*moments)) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " is not that of any body");
    diagnostic.caret = "principal moments " + format_rounded(low, 4) + ", " +
                       format_rounded(middle, 4) + ", " + format_rounded(high, 4);
    diagnostic.notes.push_back("the principal moments of a body are positive");
  });
}

}  // namespace

extern constinit const Rule sml1512_not_positive_definite{
    .id = "SML1512",
    .name = "not-positive-definite",
    .severity = Severity::error,
    .summary = "An inertia tensor has a principal moment that is not positive.",
    .why = "No body has such an inertia: sdformat reports an error, MuJoCo refuses the file, "
           "Bullet sets the inertia to 0, Drake puts a sphere of water in its place.",
    .remedy = "Compute the inertia again, e.g. from the geometry and the mass.",
    .sources = "sdformat 12.3 and MuJoCo 3.14, executed; Bullet BulletUrdfImporter.cpp:451-471; "
               "Drake detail_common.cc:446-515.",
    .check_model = check};

}  // namespace smurf::rules
