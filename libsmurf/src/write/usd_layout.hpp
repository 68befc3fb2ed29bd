// SPDX-License-Identifier: BSD-3-Clause
// Where the links of a model are in USD. A body is an Xform in the Xform of its entity. A link
// without mass that is fixed to another is no body, but a frame: an Xform in that of its body.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

struct UsdLink {
  std::size_t body = 0;  ///< the index of the link that it moves with; its own when it is a body
  Pose X_BL;             ///< in that body
  std::string path;      ///< below the entity: "arm", "hand/tool"
};

struct UsdLayout {
  std::vector<std::optional<UsdLink>> links;     ///< by index; none where no root leads to it
  std::vector<std::vector<std::size_t>> frames;  ///< by body: the frames in it
  std::string joints, materials;                 ///< names of scopes below the entity

  bool is_body(std::size_t link) const { return links[link] && links[link]->body == link; }
};

/// The model has a robot and a root.
UsdLayout usd_layout(const LinkedModel& model);

}  // namespace smurf
