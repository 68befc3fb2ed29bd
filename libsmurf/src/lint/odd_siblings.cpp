// SPDX-License-Identifier: BSD-3-Clause
#include "lint/odd_siblings.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "link/inertia.hpp"
#include "lint/queries.hpp"
#include "lint/sides.hpp"

namespace smurf {
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

}  // namespace

std::vector<OddSibling> odd_siblings(const LinkedModel& model, double most) {
  std::vector<OddSibling> found;
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
    const Sibling* odd = odd_one(members, most);
    if (odd == nullptr || is_chain(model, members)) continue;
    const Sibling& usual = odd == &members.front() ? members.back() : members.front();
    const double mass = odd->values[0] / usual.values[0];
    found.push_back({odd->link, usual.link, members.size() - 1, std::max(mass, 1 / mass),
                     factor_between(odd->values, usual.values)});
  }
  return found;
}

}  // namespace smurf
