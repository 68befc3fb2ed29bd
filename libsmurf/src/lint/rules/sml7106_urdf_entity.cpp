// SPDX-License-Identifier: BSD-3-Clause
#include "base/path.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (!entity.file || path::to_lower(path::extension(*entity.file)) != ".urdf") return;
    findings.report(entity.file.span, title(entity) + " is a URDF").help =
        "name a .smurf that lists it";
  });
}

}  // namespace

extern constinit const Rule sml7106_urdf_entity{
    .id = "SML7106",
    .name = "urdf-entity",
    .severity = Severity::error,
    .summary = "An entity is a URDF, which a target does not take.",
    .why = "MARS and Phobos load it. MARS 2 takes .smurf, .smurfs and .yml files and stops "
           "loading the scene at any other.",
    .remedy = "Write a .smurf whose `files` list the URDF.",
    .sources = "MarsSceneLoader.cpp:206-226.",
    .check_scene = check,
    .needs_target = true};

}  // namespace smurf::rules
