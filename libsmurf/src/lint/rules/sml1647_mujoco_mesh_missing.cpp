// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "link/mujoco_compiler.hpp"

namespace smurf::rules::sml1647_mujoco_mesh_missing_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::refuses, "refuses the model if the file is not there", kRun,
     when(kUncertain)},
    {&readers::mujoco, Effect::refuses, "cannot open the file, and refuses the model", "4.0.0, run",
     when(kLostToNewMujoco).since({3, 7})},
    {&readers::mujoco, Effect::refuses,
     "looks for the name of the file only, in that folder, and refuses the model",
     "2.3.7 and 3.3.7, run", when(kLostToOldMujoco).before({3, 7})},
    {&readers::mujoco, Effect::takes, "opens the file", kRun},
};

}  // namespace

extern constinit const Rule sml1647_mujoco_mesh_missing{
    .id = "SML1647",
    .name = "mujoco-mesh-missing",
    .severity = Severity::warning,
    .summary = "A mesh is not where the file tells MuJoCo to look for it.",
    .why =
        "In the element `compiler`, `meshdir` or `assetdir` is put before the path of each mesh, and `strippath` keeps only the file name. Other readers ignore both.",
    .remedy = "Name the folder that contains the meshes, relative to the URDF.",
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1647_mujoco_mesh_missing_file
