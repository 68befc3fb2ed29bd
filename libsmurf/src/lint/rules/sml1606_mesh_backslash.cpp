// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1606_mesh_backslash_file {
namespace {

constexpr Circumstance kExists{"exists"};

void check(const LinkedModel& model, Findings& findings) {
  for (const PathUses& path : paths_with(model, PathFault::backslash)) {
    const MeshReference& first = path.first();
    std::string slashes(path.filename);
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    Diagnostic& diagnostic = findings.report(first.span, "the path " + quoted(path.filename) +
                                                             " uses `\\` as separator");
    diagnostic.help("write " + quoted(slashes));
    if (first.similar.empty()) {
      diagnostic.note("there is no file of that name either");
    } else {
      diagnostic.when(kExists);
      diagnostic.fixes.push_back(rewrite(path, slashes, Applicability::safe));
    }
    if (first.is_texture) diagnostic.severity = Severity::warning;
  }
}

constexpr Fact kFacts[] = {
    {&readers::pinocchio, Effect::refuses, "does not find the mesh, and refuses the shapes", kRun,
     at("mesh")},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", kRun, at("mesh")},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
    ros_without_mesh(),
    gazebo_without_mesh(),
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun},
    kMujocoLooksBeside,
    {&readers::mujoco, Effect::takes, "treats it as a slash", kRun, when(kExists).since({3, 7})},
    {&readers::mujoco, Effect::refuses, "cannot open the file, and refuses the model", kRun},
    {&readers::phobos, Effect::loses, "keeps a mesh that it cannot open", kRun},
};

}  // namespace

extern constinit const Rule sml1606_mesh_backslash{
    .id = "SML1606",
    .name = "mesh-backslash",
    .severity = Severity::error,
    .summary = "The path of a mesh or texture uses backslashes as separators.",
    .why = "Only Windows treats a backslash as a separator; elsewhere it is part of the file name.",
    .remedy = "Write `/`, which Windows accepts, too.",
    .sources = "Bullet, MuJoCo and DART, executed on Linux.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1606_mesh_backslash_file
