// SPDX-License-Identifier: BSD-3-Clause
#include "plan/ownership.hpp"

#include <algorithm>
#include <tuple>

namespace smurf {
namespace {

/// The reasons that count before names do. Where several robots have a tie, it is with each of them
/// for a reason, so names choose again.
int class_of(const Claim& claim) {
  if (is_tie(claim.evidence)) return 0;
  if (claim.evidence <= Evidence::robot_name) return 1;
  return 2;
}

/// Smaller is better.
auto rank_of(const Claim& claim) {
  constexpr std::size_t kKnown = 10, kNear = 9;
  const bool needs_hardware = claim.kind == CompanionKind::controllers;
  const auto score = static_cast<long>(claim.known * kKnown + claim.near * kNear);
  return std::tuple(class_of(claim), claim.has_prefix, -score,
                    needs_hardware && !claim.has_hardware, claim.evidence);
}

}  // namespace

Claim claim_of(const Companion& companion, const LinkedModel& model) {
  Claim claim{companion.kind,
              companion.evidence,
              companion.known_names,
              companion.near_names.size(),
              companion.names,
              false,
              !companion.lost_prefix.empty()};
  if (!model.robot) return claim;
  for (const xml::View child : model.robot->document.view()) {
    claim.has_hardware = claim.has_hardware || child.name() == "ros2_control";
  }
  return claim;
}

std::vector<std::size_t> choose_owners(std::span<const Claim> claims) {
  std::vector<std::size_t> owners;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (!owners.empty() && rank_of(claims[owners.front()]) < rank_of(claims[i])) continue;
    if (!owners.empty() && rank_of(claims[i]) < rank_of(claims[owners.front()])) owners.clear();
    owners.push_back(i);
  }
  return owners;
}

}  // namespace smurf
