// SPDX-License-Identifier: BSD-3-Clause
// The pairs of links that do not touch in USD, for UsdPhysics.FilteredPairsAPI: of bodies, or of
// the collisions of links that are frames in a body or have such frames.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "write/parts/scene_parts.hpp"
#include "write/usd/usd_layout.hpp"

namespace smurf {

/// The links that one link does not touch. Each pair is at one of its links only.
struct UsdFilter {
  std::vector<std::size_t> bodies;  ///< with all that is in them, at the body
  std::vector<std::size_t> links;   ///< with their own collisions, at those of the link
};

class UsdFilters {
 public:
  explicit UsdFilters(const SceneExport& scene) : scene_(scene) {}
  /// Empty if nothing within a robot touches.
  const UsdFilter& of(const LinkedModel& model, const UsdLayout& layout, std::size_t link);

 private:
  using OfModel = std::map<std::size_t, UsdFilter>;

  OfModel find(const LinkedModel& model, const UsdLayout& layout) const;

  const SceneExport& scene_;
  std::map<const LinkedModel*, OfModel> of_model_;
};

}  // namespace smurf
