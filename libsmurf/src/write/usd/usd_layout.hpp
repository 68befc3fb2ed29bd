// SPDX-License-Identifier: BSD-3-Clause
// The places of the links of a model in USD. A body is an Xform in the Xform of its entity. A link
// without mass that a fixed joint holds is a frame: an Xform in the Xform of its body.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

struct UsdLink {
  std::size_t body = 0;  ///< index of the link it moves with; its own index when it is a body
  Pose X_BL;             ///< pose in that body
  std::string path;      ///< below the entity: "arm", "hand/tool"
};

struct UsdLayout {
  std::vector<std::optional<UsdLink>>
      links;  ///< by index; none if the root does not reach the link
  std::vector<std::vector<std::size_t>> frames;  ///< by body: the links that are frames in it
  std::string joints, materials;                 ///< names of scopes below the entity

  bool is_body(std::size_t link) const { return links[link] && links[link]->body == link; }
};

/// The model must have a robot and a root.
UsdLayout usd_layout(const LinkedModel& model);

}  // namespace smurf
