// SPDX-License-Identifier: BSD-3-Clause
// Meshes whose contacts a format changes.
#include <set>
#include <string>
#include <variant>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "link/shape_hulls.hpp"
#include "link/shape_solids.hpp"
#include "write/losses/found_things.hpp"

namespace smurf::things {

Found concave_meshes(const LinkedModel& model, SceneColumn) {
  Found found;
  if (!model.robot) return found;
  std::set<const MeshFile*> known;
  for (const urdf::Link& link : model.robot->links) {
    for (const urdf::Collision& shape : link.collisions) {
      const auto* mesh = std::get_if<urdf::Mesh>(&shape.geometry.shape);
      const MeshReference* reference = mesh != nullptr ? find_reference(model, *mesh) : nullptr;
      if (reference == nullptr || reference->file == nullptr ||
          !known.insert(reference->file).second) {
        continue;
      }
      const double ratio = hull_ratio(model, shape.geometry);
      if (ratio < kGapsInHull) continue;
      found.push_back({reference->span, std::string(path::file_name(reference->filename)) + ": " +
                                            format_rounded(ratio, 2) + " times"});
    }
  }
  return found;
}

}  // namespace smurf::things
