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

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "reads no scenes", "only the MARS generations and Phobos do"},
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
    .remedy =
        "Export it with smurfs-flatten: --format mjcf for MuJoCo, sdf for Gazebo, urdf for others.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7100_scene_unread_file
