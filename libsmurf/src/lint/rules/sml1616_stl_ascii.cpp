// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1616_stl_ascii_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const bool has_visuals = keeps_visuals(model);
  report_meshes(
      model,
      [&](const OpenedMesh& mesh) {
        return mesh.facts.format == MeshFormat::stl_ascii && (mesh.is_collision() || has_visuals);
      },
      "the mesh is an ASCII STL, which MuJoCo and Bullet refuse",
      "are ASCII STL, which MuJoCo and Bullet refuse", findings);
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::loses,
     "compares the size of the file with a binary count, and leaves the shape out", kRun},
    {&readers::mujoco, Effect::refuses,
     "compares the size of the file with a binary count, and refuses the model", kRun},
};

}  // namespace

extern constinit const Rule sml1616_stl_ascii{.id = "SML1616",
                                              .name = "stl-ascii",
                                              .severity = Severity::warning,
                                              .summary = "The collision mesh is an ASCII STL file.",
                                              .remedy = "Export binary STL.",
                                              .check_model = check,
                                              .facts = kFacts,
                                              .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1616_stl_ascii_file
