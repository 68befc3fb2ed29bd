// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1516_identity_inertia_file {
namespace {

/// One finding per file, because exporters write it into all links.
void check(const LinkedModel& model, Findings& findings) {
  constexpr double kPlausible = 100;  // kg; a 1 m block of this mass has nearly this inertia
  std::vector<const urdf::Link*> links;
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || !is_unit_tensor(*link.inertial)) return;
    const double mass = link.inertial->mass.value_or(0);
    if (mass <= 0 || mass >= kPlausible) return;
    links.push_back(&link);
  });
  if (links.empty()) return;
  const urdf::Link* first = links.front();
  const double mass = *first->inertial->mass;
  Diagnostic& diagnostic = findings.report(
      inertia_place(model, *first->inertial),
      "the inertia of " + title(*first) + " is the unit tensor, which looks like a placeholder");
  diagnostic.caret = "that of a ball of " + format_rounded(2 * std::sqrt(2.5 / mass), 2) +
                     " m and " + format_rounded(mass, 3) + " kg";
  for (std::size_t i = 1; i < links.size(); ++i) {
    diagnostic.label(inertia_place(model, *links[i]->inertial), "that of " + title(*links[i]));
  }
  if (links.size() > 1) {
    diagnostic.note(counted(links.size() - 1, "more link") + " in this file");
  }
}

}  // namespace

extern constinit const Rule sml1516_identity_inertia{
    .id = "SML1516",
    .name = "identity-inertia",
    .severity = Severity::warning,
    .summary = "An inertia is the unit tensor.",
    .why = "CAD tools and templates write it as a placeholder. A body of 1 kg with this inertia is "
           "about two metres wide, so joints respond far too slowly.",
    .remedy = "Compute the inertia from the geometry and the mass.",
    .sources = "14 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1516_identity_inertia_file
