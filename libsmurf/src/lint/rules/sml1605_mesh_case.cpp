// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1605_mesh_case_file {
namespace {

/// The path as written, with upper and lower case of the existing file.
std::string corrected(const MeshReference& reference) {
  const std::string& there = reference.similar;
  std::size_t same = 0;  // compares from the end, ignoring case
  const std::string written = path::to_lower(reference.filename);
  const std::string found = path::to_lower(there);
  while (same < written.size() && same < found.size() &&
         written[written.size() - 1 - same] == found[found.size() - 1 - same]) {
    ++same;
  }
  return reference.filename.substr(0, written.size() - same) + there.substr(found.size() - same);
}

void check(const LinkedModel& model, Findings& findings) {
  for (const PathUses& path : paths_with(model, PathFault::other_case)) {
    const MeshReference& first = path.first();
    Diagnostic& diagnostic =
        findings.report(first.span, "file not found: " + quoted(path.filename) +
                                        "; the name of an existing file differs only in case");
    diagnostic.caret = "the file is " + quoted(first.similar);
    diagnostic.help("write " + quoted(corrected(first)));
    diagnostic.fixes.push_back(rewrite(path, corrected(first), Applicability::safe));
    if (first.is_texture) diagnostic.severity = Severity::warning;
  }
}

constexpr Fact kFacts[] = {
    kMarsWithoutCollision,
    mars_without_mesh(),
    {&readers::pybullet, Effect::takes, "does without a texture", kRun, at("texture")},
    {&readers::pinocchio, Effect::takes, "does not look at textures", kRun, at("texture")},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot",
     "Bullet UrdfFindMeshFile.h, run"},
    ros_without_mesh(),
    gazebo_without_mesh(),
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun},
    kMujocoLooksBeside,
    {&readers::mujoco, Effect::refuses, "cannot open the file, and refuses the model", kRun},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
    {&readers::phobos, Effect::loses, "keeps a mesh that it cannot open", kRun},
    {&readers::pinocchio, Effect::refuses, "does not find the mesh, and refuses the shapes", kRun},
};

}  // namespace

extern constinit const Rule sml1605_mesh_case{
    .id = "SML1605",
    .name = "mesh-case",
    .severity = Severity::error,
    .summary = "The path of a mesh or texture differs from the file name in upper and lower case.",
    .why = "Only Windows and macOS find the file; on Linux it is missing.",
    .remedy = "Write the name of the file as it is on disk.",
    .sources = "executed on Linux.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1605_mesh_case_file
