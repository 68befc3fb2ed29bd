// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "link/shape_hulls.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1654_concave_collision_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const OpenedMesh* worst = nullptr;
  double largest = findings.tolerance();
  std::size_t others = 0;
  const std::vector<OpenedMesh> meshes = opened_meshes(model);
  for (const OpenedMesh& mesh : meshes) {
    if (!mesh.is_collision()) continue;
    const double ratio = hull_ratio(model, mesh.uses.front().geometry);
    if (ratio < findings.tolerance()) continue;
    ++others;
    if (ratio <= largest && worst != nullptr) continue;
    worst = &mesh;
    largest = ratio;
  }
  if (worst == nullptr) return;
  Diagnostic& diagnostic =
      findings.report(worst->reference.span, "the convex hull of the collision mesh has " +
                                                 format_rounded(largest, 2) + " times its volume");
  diagnostic.note("in a simulator that uses the hull, its gaps and holes are full");
  if (others > 1)
    diagnostic.note(counted(others - 1, "more mesh", "more meshes") + " of this robot");
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::changes, "uses the convex hull for contacts", kRun},
    {&readers::pybullet, Effect::changes, "uses the convex hull for contacts", kRun},
    {&readers::drake, Effect::changes, "uses the convex hull for contacts",
     "Drake make_convex_hull_mesh_impl.cc:279-291"},
};

}  // namespace

extern constinit const Rule sml1654_concave_collision{
    .id = "SML1654",
    .name = "concave-collision",
    .severity = Severity::info,
    .summary = "The convex hull of a collision mesh is much larger than the mesh.",
    .why =
        "Where simulators use the hull for contacts, nothing fits between the fingers of a fork, "
        "and a gripper closes on air.",
    .remedy =
        "Divide the mesh into convex parts, each in one `collision`: `--collision parts` of "
        "smurf2urdf and smurfs-flatten does this with CoACD, for some links with `--collision "
        "'gripper_*=parts'`.",
    .sources = "13 threads on simulators, such as MuJoCo issue 1873 and Bullet issue 1954.",
    .check_model = check,
    .needs_target = true,
    .tolerance = {.value = kGapsInHull,
                  .meaning = "the volume of the hull, as a multiple of that of the mesh"},
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1654_concave_collision_file
