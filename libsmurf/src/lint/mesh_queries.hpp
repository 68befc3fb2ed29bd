// SPDX-License-Identifier: BSD-3-Clause
// Questions about mesh files: why a file cannot be found, the contents of opened files, and their
// users.
#pragma once

#include <string>
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf {

/// The reason why a path cannot be loaded. One rule reports each reason, so each path gets one
/// finding.
enum class PathFault : std::uint8_t {
  none,
  empty,              ///< SML1603
  missing,            ///< SML1604
  other_case,         ///< SML1605
  backslash,          ///< SML1606
  absolute,           ///< SML1607, whether the file is there or not
  malformed_package,  ///< SML1609
  scheme,             ///< SML1610, whether the file is there or not
  found_by_mars_only  ///< SML1604, with a note
};
PathFault path_fault(const MeshReference& reference);

/// Whether the file lies outside of the project, so that it may exist or not.
bool lies_outside(const MeshReference& reference);

/// The meshes and textures of the URDF. Those of collisions come first, because all readers need
/// them and one finding represents many files.
std::vector<const MeshReference*> collisions_first(const LinkedModel& model);

/// References of one kind that name the same path, in document order.
struct PathUses {
  std::string_view filename;
  std::vector<const MeshReference*> references;

  const MeshReference& first() const { return *references.front(); }
};
/// The paths of a model that have this fault.
std::vector<PathUses> paths_with(const LinkedModel& model, PathFault fault);

/// A fix that replaces the path wherever it occurs.
Fix rewrite(const PathUses& path, std::string_view filename, Applicability applicability);

/// NAME of package://NAME/REST; empty for other paths.
std::string_view package_of(std::string_view filename);

/// Whether the format of an opened file differs from its extension (SML1645).
bool has_other_format(const MeshReference& reference);

/// A mesh file that was opened and read, and the visuals and collisions that use it.
struct OpenedMesh {
  /// The first of a collision, which all readers need; without collisions, the first.
  const MeshReference& reference;
  const MeshFile& file;
  const MeshFacts& facts;
  std::vector<GeometryUse> uses;

  bool is_collision() const;
};
/// Mesh files in the order of their first use, except for files that could not be read.
std::vector<OpenedMesh> opened_meshes(const LinkedModel& model);

/// Reports one finding for several meshes, at the first of a collision, or the first of them. `one`
/// is the message for one file, `many` the text after "12 mesh files". Null if there are no meshes.
Diagnostic* report_meshes(const LinkedModel& model,
                          const std::function<bool(const OpenedMesh&)>& is_at_fault,
                          std::string_view one, std::string_view many, Findings& findings);

/// Reports one finding, at the first reference, for all files that MARS rotates; nothing if there
/// are no references. `kind` is as in "12 STL files".
void report_turned(const std::vector<const MeshReference*>& turned, std::string message,
                   std::string_view kind, Findings& findings);

}  // namespace smurf
