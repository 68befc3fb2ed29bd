// SPDX-License-Identifier: BSD-3-Clause
// The format of a mesh file and the size of its content, without its triangles.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/pose.hpp"

namespace smurf {

/// Decided by the bytes, not the name.
enum class MeshFormat : std::uint8_t {
  unknown,
  stl_binary,
  stl_ascii,
  obj,
  collada,
  bobj,  ///< MARS: records of vertices, normals and triangles
  gltf,  ///< JSON or binary
  lfs_pointer
};
/// "binary STL".
std::string_view to_string(MeshFormat format);

/// Axis-aligned: every point is between `low` and `high`, both included.
struct Box {
  Vector3 low{}, high{};

  Vector3 size() const { return {high[0] - low[0], high[1] - low[1], high[2] - low[2]}; }
  Vector3 center() const {
    return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
  }
  friend bool operator==(const Box&, const Box&) = default;
};

/// The body that a surface encloses, at density 1.
struct Solid {
  double volume = 0;  ///< negative if the triangles face inward
  Vector3 center{};   ///< of the volume
  /// Integrals of xx, yy, zz, xy, xz and yz over the volume, about the center.
  std::array<double, 6> second{};
};

/// How the triangles of a surface fit together.
enum class Closure : std::uint8_t {
  unknown,
  closed,   ///< each edge joins two triangles that face the same side
  flipped,  ///< each edge joins two triangles, but some face inward and some outward
  open      ///< some edges belong to one triangle
};

/// The first place where a mesh file breaks the rules of its format.
struct MeshDefect {
  std::string what;          ///< "the file ends inside a facet"
  std::uint64_t offset = 0;  ///< byte
  std::uint32_t line = 0;    ///< 1-based; 0 in a binary file
};

/// Another file that a mesh names.
struct MeshDependency {
  enum class Kind : std::uint8_t {
    material_library,  ///< of OBJ; may refer to textures
    texture,
    buffer  ///< of glTF; contains the points
  };

  std::string filename;  ///< as written, but unquoted
  Kind kind = Kind::texture;
  std::uint32_t line = 0;    ///< 1-based; 0 in a binary file
  std::uint64_t offset = 0;  ///< of the bytes with the name, with its quotes
  std::uint64_t length = 0;
  bool is_denied = false;  ///< it is outside of the project, and may exist or not

  /// The path without `file://`, and with spaces for `%20`.
  std::string path() const;
};

/// Facts about a mesh. All lengths are in the file's own unit and axes, before any scale of the
/// URDF; glTF, whose y axis is up, is turned to z.
struct MeshFacts {
  MeshFormat format = MeshFormat::unknown;
  std::uint64_t bytes = 0;
  std::uint64_t triangles = 0;  ///< each polygon counts as its triangles
  std::uint64_t vertices = 0;   ///< as stored: binary STL stores three per triangle
  /// Encloses all vertices. For COLLADA and glTF it encloses the scene with the transforms of its
  /// nodes, and the turned boxes of turned nodes. Absent when there are none or they cannot be
  /// placed.
  std::optional<Box> box;
  /// Present only if the surface looks closed, that is, if its area vectors add up to zero.
  /// COLLADA: in the unit of the file, with the transforms of its nodes.
  std::optional<Solid> solid;
  Closure closure = Closure::unknown;
  /// Corners of the triangles, in the frame of `solid`: all of a small mesh, else those that are
  /// outermost in 26 directions, and a sample of the others.
  std::vector<std::array<float, 3>> outer;
  std::optional<double> unit_meters;  ///< COLLADA: metres per unit, if written
  char up_axis = '\0';                ///< COLLADA: 'X', 'Y' or 'Z', when written
  bool has_more_groups = false;       ///< OBJ: faces behind those of the first `o` or `g`
  bool is_first_group_flat = false;   ///< OBJ: the faces of the first `o` or `g` lie in a plane
  bool named_solid = false;           ///< binary STL whose header begins like an ASCII one
  std::vector<std::string> extras;  ///< COLLADA: contents such as "lights", "cameras", "animations"
  std::vector<MeshDependency> dependencies;
  std::optional<MeshDefect> defect;
  /// glTF: the reason why triangles and box are unknown although the file is not broken: "has
  /// skins, which are not read".
  std::string unread;
};

/// The other files that a mesh file or a material library (.mtl) names. A name may be written
/// several times.
std::vector<MeshDependency> files_named_in(std::string_view bytes, std::string_view extension);
/// Old names, as written, and new names, which contain only characters that need no quotes.
using FileNames = std::map<std::string, std::string>;
/// The file with new names. All other bytes are unchanged, except for sizes in a binary glTF.
std::string with_other_names(std::string_view bytes, std::string_view extension,
                             const FileNames& names);

/// A mesh file that was opened.
struct MeshFile {
  ReadStatus status = ReadStatus::not_found;
  std::string reason;  ///< message for people, if status is not ok
  MeshFacts facts;     ///< if status is ok
  /// The files that it names and that are not there.
  std::vector<MeshDependency> lost;
};

/// The meshes of a run: each file is read once, even if many models use it. Several threads may
/// read at the same time. Returned references are valid as long as the library.
class MeshLibrary {
 public:
  MeshLibrary();
  ~MeshLibrary();
  MeshLibrary(MeshLibrary&& other) noexcept;
  MeshLibrary& operator=(MeshLibrary&& other) noexcept;

  const MeshFile& read(const std::string& path, const FileReader& files, const Limits& limits);

 private:
  struct Shelves;
  std::unique_ptr<Shelves> shelves_;
};

}  // namespace smurf
