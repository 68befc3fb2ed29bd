// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "link/imported_world.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7100_scene_unread_file {
namespace {

constexpr Circumstance kSmurfa{".smurfa"};

void check(const LinkedScene& scene, Findings& findings) {
  const SceneFile& file = scene.scenes.front();
  if (!file.document || !file.document->view() || !file.document->view().is_mapping()) return;
  const yaml::View first = *file.document->view().begin();
  if (!first) return;
  const std::string_view extension = path::extension(file.path);
  // A world of SDF is none for people; its models are judged as robots.
  if (has_name_of_world(file.path)) return;
  Diagnostic& diagnostic =
      findings.report(first.key_span(), "this is a SMURF scene, and not a robot");
  if (extension == ".smurfa") diagnostic.when(kSmurfa);
}

constexpr std::string_view kReadsNone = "reads no scenes";
constexpr std::string_view kEvidence = "only the MARS generations and Phobos do";

/// A reader that reads no scenes, but a format that smurfs-flatten writes.
constexpr Fact reads_only(const Reader& reader, std::string_view cure) {
  return {&reader, Effect::refuses, kReadsNone, kEvidence, {}, cure};
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, kReadsNone, kEvidence},
    reads_only(readers::gazebo, "export it: smurfs-flatten --format sdf"),
    reads_only(readers::mujoco, "export it: smurfs-flatten --format mjcf"),
    reads_only(readers::drake, "export it: smurfs-flatten --format dmd"),
    reads_only(readers::isaac, "export it: smurfs-flatten --format usda"),
    reads_only(readers::newton, "export it: smurfs-flatten --format usda"),
    {&readers::mars, Effect::takes, "reads scenes and assemblies", "MARS SMURFLoader.cpp"},
    {&readers::mars2, Effect::refuses, "reads .smurfs only", "MarsSceneLoader.cpp:76",
     when(kSmurfa)},
    {&readers::mars2, Effect::takes, "reads scenes", "MarsSceneLoader.cpp:76"},
    {&readers::phobos, Effect::takes, "reads scenes and assemblies", "Phobos core/multiple.py"},
    {&readers::pybullet, Effect::refuses, "reads .smurfs only (the script of Phobos)",
     "Phobos scripts/smurfs_in_pybullet.py", when(kSmurfa)},
    {&readers::pybullet, Effect::takes, "reads scenes (the script of Phobos)",
     "Phobos scripts/smurfs_in_pybullet.py, run"},
};

}  // namespace

extern constinit const Rule sml7100_scene_unread{
    .id = "SML7100",
    .name = "scene-unread",
    .severity = Severity::error,
    .summary = "A target does not read scenes.",
    .remedy = "Export it: smurfs-flatten --format urdf; --format help lists the others.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7100_scene_unread_file
