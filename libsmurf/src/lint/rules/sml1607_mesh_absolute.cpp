// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>

#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"
#include "lint/ros_paths.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1607_mesh_absolute_file {
namespace {

constexpr Circumstance kExists{"exists"};

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string_view, std::vector<const PathUses*>> by_folder;
  const std::vector<PathUses> paths = paths_with(model, PathFault::absolute);
  for (const PathUses& path : paths) {
    by_folder[path.filename.substr(0, path.filename.find_last_of("/\\"))].push_back(&path);
  }
  for (const auto& [folder, files] : by_folder) {
    const MeshReference& first = files.front()->first();
    // What `$(find PACKAGE)` of a xacro stands for is in a package.
    const bool is_in_package = first.exists && !first.meant.empty();
    Diagnostic& diagnostic = findings.report(
        first.span, is_in_package && model.language == Language::xacro
                        ? "RViz and MoveIt do not open " + quoted(first.filename) +
                              ", which is a path and no address"
                        : "the path " + quoted(first.filename) + " exists on one machine only");
    // What lies outside of the project is judged as on a machine without it.
    const bool do_all_exist = std::all_of(files.begin(), files.end(), [](const PathUses* path) {
      return path->first().exists && !lies_outside(path->first());
    });
    if (do_all_exist) diagnostic.when(kExists);
    if (!first.exists) diagnostic.caret = "not found here";
    if (lies_outside(first)) diagnostic.caret = "outside of the project, and not looked up";
    if (first.exists || first.is_texture) diagnostic.severity = Severity::warning;
    if (files.size() > 1) {
      diagnostic.note("the URDF names " + std::to_string(files.size()) + " files in this folder");
    }
    diagnostic.help(is_in_package ? "write " + quoted(first.meant)
                                  : "write `package://NAME/PATH`, or a path relative to the URDF");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "puts the folder of the model before it, finds nothing, and ends with an exception",
     "MARS misc.cpp:112-131", at("collision")},
    {&readers::pybullet, Effect::takes, "opens the file", kRun, when(kExists)},
    {&readers::pybullet, Effect::takes, "does without a texture", kRun, at("texture")},
    {&readers::pybullet, Effect::refuses, "where the file is missing, refuses the whole robot",
     "Bullet UrdfFindMeshFile.h, run"},
    {&readers::ros, Effect::loses, kOpensAddressesOnly, kRetriever},
    {&readers::moveit, Effect::loses, kOpensAddressesOnly, kRetriever},
    {&readers::gazebo, Effect::takes, "opens the file", kRun, when(kExists)},
    {&readers::gazebo, Effect::loses, "where the file is missing, leaves the shape out",
     "sdformat parser_urdf.cc:2416-2431"},
    {&readers::dart, Effect::takes, "opens the file", kRun, when(kExists)},
    {&readers::dart, Effect::refuses,
     "where the file is missing, cannot load the shape, and refuses the file", kRun},
    kMujocoLooksBeside,
    {&readers::mujoco, Effect::takes, "opens the file", "3.14.0, run", when(kExists).since({3, 7})},
    {&readers::mujoco, Effect::refuses,
     "where the file is missing, cannot open the file, and refuses the model", kRun},
    {&readers::drake, Effect::takes, "opens the file", kRun, when(kExists)},
    {&readers::drake, Effect::refuses, "where the file is missing, refuses the file", kRun},
    {&readers::pinocchio, Effect::takes, "opens the file", kRun, when(kExists)},
    {&readers::pinocchio, Effect::takes, "does not look at textures", kRun, at("texture")},
    {&readers::pinocchio, Effect::refuses, "does not find the mesh, and refuses the shapes", kRun},
    {&readers::newton, Effect::takes, "opens the file", kRun, when(kExists)},
    newton_without_mesh(),
    {&readers::isaac, Effect::takes, "opens the file", kRun, when(kExists)},
};

}  // namespace

extern constinit const Rule sml1607_mesh_absolute{
    .id = "SML1607",
    .name = "mesh-absolute",
    .severity = Severity::error,
    .summary = "A mesh or texture is named by an absolute path.",
    .why = "The file is found on one machine only; elsewhere it is missing.",
    .remedy = "Write a path relative to the URDF, or package://.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1607_mesh_absolute_file
