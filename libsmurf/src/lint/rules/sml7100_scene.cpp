// SPDX-License-Identifier: BSD-3-Clause
#include "base/path.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  const SceneFile& file = scene.scenes.front();
  if (!file.document || !file.document->view() || !file.document->view().is_mapping()) return;
  const yaml::View first = *file.document->view().begin();
  if (!first) return;
  const std::string_view extension = path::extension(file.path);
  findings.report(first.key_span(), "this is a SMURF scene").construct =
      extension.empty() ? extension : extension.substr(1);
}

}  // namespace

extern constinit const Rule sml7100_scene{
    .id = "SML7100",
    .name = "scene",
    .severity = Severity::error,
    .summary = "A scene is given to a target that reads no scenes.",
    .why = "Only the MARS generations and Phobos read SMURF scenes; MARS 2 and the pybullet "
           "script of Phobos read no .smurfa.",
    .remedy = "Expand the scene with smurfs-flatten.",
    .sources =
        "MARS SMURFLoader.cpp; MarsSceneLoader.cpp:76; Phobos scripts/smurfs_in_pybullet.py.",
    .check_scene = check,
    .needs_target = true};

}  // namespace smurf::rules
