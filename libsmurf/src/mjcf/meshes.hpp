// SPDX-License-Identifier: BSD-3-Clause
// The meshes of `<asset>`: what MuJoCo computes of their triangles.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "imports/mass.hpp"
#include "mjcf/file.hpp"

namespace smurf::mjcf {

struct Triangles {
  std::vector<Vector3> points;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

enum class MeshInertia : std::uint8_t { convex, exact, legacy, shell };
/// Mass, centre and inertia of density 1; none if the volume is too small or negative.
std::optional<MassProperties> properties_of(const Triangles& mesh, MeshInertia mode);

struct Mesh {
  Settings settings;
  std::string path;  ///< empty for a mesh that is written in the model
  Vector3 scale{1, 1, 1};
  Pose origin;  ///< of the points of the file, if the scale is the same in all directions or
                ///< nothing is turned
  bool is_sheared = false;
  bool is_read = false;  ///< its triangles are known
  MeshInertia mode = MeshInertia::legacy;
  std::optional<MassProperties>
      properties;           ///< of density 1, in the frame of the mesh; none: unknown
  bool is_refused = false;  ///< there are triangles, but no volume
  Vector3 low{}, high{};    ///< along the principal axes, about the centre
};

class Meshes {
 public:
  explicit Meshes(Reporter& reporter) : reporter_(reporter) {}
  /// The mesh of a name in a file's model; null if there is none. Its triangles are read only if a
  /// mass needs them.
  const Mesh* find(const ModelFile& file, const std::string& name, bool needs_mass);

 private:
  using Key = std::pair<const ModelFile*, std::string>;
  void list(const ModelFile& file);
  void read(const ModelFile& file, Mesh& mesh);
  std::optional<Triangles> triangles_of(const Mesh& mesh);

  Reporter& reporter_;
  std::map<Key, Mesh> meshes_;
  std::map<const ModelFile*, bool> listed_;
};

}  // namespace smurf::mjcf
