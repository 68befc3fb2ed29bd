// SPDX-License-Identifier: BSD-3-Clause
// The planning pipelines in parameter files of MoveIt, and the releases that they are written for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lint/queries.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// What only Humble reads, or only Jazzy and later ones.
struct ReleaseSign {
  Span place;
  std::string what, help;  ///< what to write for the other releases
};
struct MisspeltAdapter {
  yaml::View value;  ///< one adapter, or a text with several
  std::string_view name, meant;
};
struct MoveitPipeline {
  std::vector<ReleaseSign> humble, later;
  std::vector<MisspeltAdapter> misspelt;
  std::optional<Span> without_times;  ///< response adapters, none of which computes times
};
/// The pipelines of all files of MoveIt 2, one for each mapping that has one.
std::vector<MoveitPipeline> moveit_pipelines(const Companions& companions);

}  // namespace smurf
