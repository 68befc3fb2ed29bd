// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7105_included_scene_file {
namespace {

constexpr Circumstance kPlaced{"placed"};

bool has_pose(const Entity& entity) {
  return entity.position.written || entity.rotation.form != RotationForm::absent;
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (!entity.file) return;
    const std::string extension = path::to_lower(path::extension(*entity.file));
    if (extension != ".smurfs" && extension != ".smurfa") return;
    Diagnostic& diagnostic =
        findings.report(entity.file.span, title(entity) + " includes another scene");
    if (has_pose(entity)) diagnostic.when(kPlaced);
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "composes the poses and loads all entities",
     "MARS SMURFLoader.cpp"},
    {&readers::mars2, Effect::loses, "loads only its .yml entities, and ignores the pose",
     "MarsSceneLoader.cpp:209, 249-298"},
    {&readers::pybullet, Effect::changes, "ignores the pose of the include",
     "Phobos scripts/smurfs_in_pybullet.py:105-107, run", when(kPlaced)},
};

}  // namespace

extern constinit const Rule sml7105_included_scene{
    .id = "SML7105",
    .name = "included-scene",
    .severity = Severity::warning,
    .summary = "A scene includes another one, of which a target loads only a part.",
    .remedy = "Write all entities into one scene: smurfs-flatten computes their poses.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7105_included_scene_file
