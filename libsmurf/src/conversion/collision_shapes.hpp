// SPDX-License-Identifier: BSD-3-Clause
// The shapes that replace a collision mesh: its hull, convex parts, a box, a capsule or a lighter
// mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "conversion/mesh_pieces.hpp"
#include "mesh/convex_mesh.hpp"
#include "smurf/conversion.hpp"

namespace smurf {

/// One of the shapes that replace a mesh.
struct NewShape {
  std::string file;     ///< of a mesh, relative to the output folder; "": it is no mesh
  std::string element;  ///< that says it in a URDF, if it is no mesh
  Pose X_CS;            ///< in the frame of the collision
  bool is_moved = false;
  std::string ending;  ///< of its name: "", "_part_2", "_top"
};

/// All of them.
struct NewShapes {
  std::vector<NewShape> shapes;  ///< empty: the mesh is kept
  std::vector<TextFile> files;   ///< the new meshes, relative to the output folder
  ReplacedCollision about;
};

class CollisionShaper {
 public:
  CollisionShaper(const CollisionRequest& request, const FileReader& files, const Limits& limits)
      : request_(request), files_(files), limits_(limits) {}

  /// Called once, before the first mesh is divided.
  void before_dividing(std::function<void()> tell) { tell_ = std::move(tell); }
  /// The shapes for a mesh file. `volume` of the scaled mesh, if it is known, in m^3. Without
  /// `has_capsules`, a capsule is a cylinder and two balls.
  NewShapes make(const MeshReference& mesh, const Vector3& scale, CollisionShapes shapes,
                 std::optional<double> volume, bool has_capsules);
  /// Why no mesh can have the shapes that were asked for; "" if some can.
  const std::string& problem() const { return problem_; }

 private:
  std::string new_file(const MeshReference& mesh, const std::string& ending);
  void add_mesh(const MeshReference& mesh, const CollisionBody& body, const std::string& ending,
                const std::string& name_ending, NewShapes& made);
  void add_lighter(const MeshReference& mesh, const CollisionBody& body,
                   std::optional<double> volume, NewShapes& made);
  /// The convex parts of a mesh with this hull; empty, with the reason in `kept`, if there are
  /// none.
  std::vector<ConvexMesh> parts_of(const CollisionBody& body, const ConvexMesh& hull,
                                   std::optional<double> volume, std::string& kept);
  /// The same for one closed surface, or for an open mesh, whose volume is not known.
  std::vector<ConvexMesh> divided(const CollisionBody& body, const ConvexMesh& hull,
                                  std::optional<double> volume, bool is_closed,
                                  std::size_t most_parts, std::string& kept);

  const CollisionRequest& request_;
  const FileReader& files_;
  const Limits& limits_;
  std::set<std::string> names_;  ///< of new files, in lower case
  std::string problem_;
  std::function<void()> tell_;
};

}  // namespace smurf
