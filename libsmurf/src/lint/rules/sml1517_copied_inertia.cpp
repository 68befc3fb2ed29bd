// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <map>
#include <vector>

#include "link/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1517_copied_inertia_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr std::size_t kFewest = 5;  // links
  std::map<std::array<double, 7>, std::vector<const urdf::Link*>> by_value;
  std::size_t count = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || !principal_moments(*link.inertial)) return;
    const urdf::Inertial& own = *link.inertial;
    if (own.mass.value_or(0) <= 0 || is_unit_tensor(own)) return;
    ++count;
    by_value[{*own.mass, *own.ixx, *own.ixy, *own.ixz, *own.iyy, *own.iyz, *own.izz}].push_back(
        &link);
  });
  for (const auto& [value, links] : by_value) {
    if (links.size() < kFewest || 2 * links.size() <= count) continue;
    Diagnostic& diagnostic = findings.report(
        inertia_place(model, *links[0]->inertial),
        std::to_string(links.size()) + " of " + std::to_string(count) +
            " links with a mass have this mass and inertia, as if copied from a template");
    diagnostic.label(inertia_place(model, *links[1]->inertial), "the same again");
  }
}

}  // namespace

extern constinit const Rule sml1517_copied_inertia{
    .id = "SML1517",
    .name = "copied-inertia",
    .severity = Severity::info,
    .summary = "Most links have the same mass and inertia.",
    .why = "Parts of a robot differ. Equal numbers are placeholders, and the simulated robot moves "
           "differently from the real one.",
    .remedy = "Compute mass and inertia from the geometry of each link.",
    .sources = "23 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1517_copied_inertia_file
