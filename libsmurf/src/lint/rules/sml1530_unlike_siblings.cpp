// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"
#include "lint/sides.hpp"

namespace smurf::rules::sml1530_unlike_siblings_file {
namespace {

/// Mass and principal moments of a link.
using Values = std::array<double, 4>;

struct Sibling {
  const urdf::Link* link;
  std::size_t index;  ///< of the link
  Values values;
};

double factor_between(const Values& a, const Values& b) {
  double worst = 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max({worst, a[i] / b[i], b[i] / a[i]});
  }
  return worst;
}

bool are_alike(const Sibling& a, const Sibling& b) {
  constexpr double kAlike = 1.01;
  return factor_between(a.values, b.values) <= kAlike;
}

/// The only member that differs from all others, which are alike.
const Sibling* odd_one(const std::vector<Sibling>& group, double most) {
  if (group.size() < 3) return nullptr;  // of two, none is odd
  // At most one of the first three is odd, so the other two show what is usual.
  const bool is_first_usual = are_alike(group[0], group[1]) || are_alike(group[0], group[2]);
  const Sibling& usual = is_first_usual ? group[0] : group[1];
  const Sibling* odd = nullptr;
  for (const Sibling& one : group) {
    if (are_alike(one, usual)) continue;
    if (odd != nullptr) return nullptr;
    odd = &one;
  }
  return odd != nullptr && factor_between(odd->values, usual.values) > most ? odd : nullptr;
}

/// Links of a chain, such as wrist_1 to wrist_3, are numbered, too, but differ.
bool is_chain(const LinkedModel& model, const std::vector<Sibling>& group) {
  std::vector<std::size_t> members;
  for (const Sibling& one : group) members.push_back(one.index);
  return has_chain(model, members);
}

void report(const LinkedModel& model, const std::vector<Sibling>& group, Findings& findings) {
  const Sibling* odd = odd_one(group, findings.tolerance());
  if (odd == nullptr || is_chain(model, group)) return;
  const Sibling& other = odd == &group.front() ? group.back() : group.front();
  const bool is_mass = std::max(odd->values[0] / other.values[0],
                                other.values[0] / odd->values[0]) > findings.tolerance();
  const urdf::Inertial& own = *odd->link->inertial;
  Diagnostic& diagnostic = findings.report(
      is_mass ? own.mass.span : inertia_place(model, own),
      title(*odd->link) + " differs from " + std::to_string(group.size() - 1) +
          " others like it: its " + (is_mass ? "mass" : "inertia") + " by a factor of " +
          format_rounded(factor_between(odd->values, other.values), 3));
  const urdf::Inertial& usual = *other.link->inertial;
  diagnostic.label(is_mass ? usual.mass.span : inertia_place(model, usual), "one of the others");
}

void check(const LinkedModel& model, Findings& findings) {
  std::vector<std::string_view> names;
  std::vector<Sibling> links;
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t at = index++;
    if (!link.name || !link.inertial || !(link.inertial->mass.value_or(0) > 0)) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments || !is_positive_definite(*moments)) return;
    names.emplace_back(*link.name);
    const auto& [low, middle, high] = *moments;
    links.push_back({&link, at, {*link.inertial->mass, low, middle, high}});
  });
  for (const std::vector<std::size_t>& group : siblings_of(names)) {
    std::vector<Sibling> members;
    for (const std::size_t member : group) members.push_back(links[member]);
    report(model, members, findings);
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
    .tolerance = {.value = 1.5, .meaning = "the factor by which one may differ from the others"}};

}  // namespace smurf::rules::sml1530_unlike_siblings_file
