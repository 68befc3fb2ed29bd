// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <map>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1659_mujoco_mesh_sizes_file {
namespace {

/// The first use of a mesh, and the first one with another scale.
struct Uses {
  const urdf::Mesh* first = nullptr;
  const urdf::Mesh* other = nullptr;
};

Vector3 scale_of(const urdf::Mesh& mesh) { return mesh.scale.value_or(Vector3{1, 1, 1}); }

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string, Uses, std::less<>> uses_by_stem;
  const bool has_visuals = keeps_visuals(model);
  for_each_geometry(model, [&](const GeometryUse& use) {
    const urdf::Mesh* mesh = use.mesh();
    if (mesh == nullptr || (use.role == GeometryRole::visual && !has_visuals)) return;
    const MeshReference* reference = find_reference(model, *mesh);
    if (reference == nullptr || reference->filename.empty()) return;
    Uses& uses = uses_by_stem[std::string(path::stem(reference->filename))];
    if (uses.first == nullptr) {
      uses.first = mesh;
    } else if (scale_of(*mesh) == scale_of(*uses.first)) {
      return;
    } else if (uses.other == nullptr) {
      uses.other = mesh;
    } else {
      findings
          .report(reference->span, "another size of a mesh called " +
                                       quoted(path::stem(reference->filename)) +
                                       " is in use already")
          .label(uses.first->filename.span, "the first size")
          .label(uses.other->filename.span, "the other one");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::refuses,
     "makes one name of the file for each use that is not of the first size, and refuses the second",
     "3.2.2, run", before({3, 2, 3})},
    {&readers::mujoco, Effect::takes, "tells the sizes of a mesh apart", "3.2.3, run"},
};

}  // namespace

extern constinit const Rule sml1659_mujoco_mesh_sizes{
    .id = "SML1659",
    .name = "mujoco-mesh-sizes",
    .severity = Severity::warning,
    .summary = "A mesh is used twice in another size than at its first use.",
    .remedy = "Use copies of the file with other names, or a newer MuJoCo.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1659_mujoco_mesh_sizes_file
