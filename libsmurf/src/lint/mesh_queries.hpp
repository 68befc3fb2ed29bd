// SPDX-License-Identifier: BSD-3-Clause
// Questions about mesh files: which cannot be found and why, what those that were opened hold, and
// who uses them.
#pragma once

#include <string>
#include <vector>

#include "base/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf {

/// Why nothing can be loaded from a path. One rule reports each cause, so that a path gets one
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

/// A fix that writes another path wherever this one stands.
Fix rewrite(const PathUses& path, std::string_view filename, Applicability applicability);

/// NAME of package://NAME/REST; empty for other paths.
std::string_view package_of(std::string_view filename);

/// True when an opened file holds something else than its extension says (SML1645).
bool has_other_format(const MeshReference& reference);

/// A mesh file that was opened and read, and the visuals and collisions that use it.
struct OpenedMesh {
  const MeshReference& reference;  ///< the first
  const MeshFile& file;
  const MeshFacts& facts;
  std::vector<GeometryUse> uses;

  bool is_collision() const;
};
/// Mesh files in the order of their first use; those that could not be read are left out.
std::vector<OpenedMesh> opened_meshes(const LinkedModel& model);

/// One finding for the meshes that have something in common, at the first of them: `one` says what
/// when there is one such file, `many` what follows "12 mesh files". Null when there is none.
Diagnostic* report_meshes(const LinkedModel& model,
                          const std::function<bool(const OpenedMesh&)>& is_at_fault,
                          std::string_view one, std::string_view many, Findings& findings);

/// One finding, at the first of these references, for all files that MARS turns; none without
/// references. `kind` is as in "12 STL files".
void report_turned(const std::vector<const MeshReference*>& turned, std::string message,
                   std::string_view kind, Findings& findings);

}  // namespace smurf
