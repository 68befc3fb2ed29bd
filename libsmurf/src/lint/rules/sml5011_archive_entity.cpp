// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"
#include "smurf/archive_files.hpp"

namespace smurf::rules::sml5011_archive_entity_file {
namespace {

void report(const Entity& entity, Findings& findings) {
  if (!is_archive_type(entity_type(entity))) return;
  findings.report(type_place(entity),
                  title(entity) + " is an archive, of which MARS loads nothing");
}

/// Another rule reports an archive that cannot be read.
void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneUse& use : scene.uses) {
    if (use.outer && scene.file(use).document) report(*scene.entity(use), findings);
  }
  for (const Instance& instance : scene.instances) {
    if (instance.model) report(scene.entity(instance), findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "loads nothing and reports success",
     "MARS SMURFLoader.cpp:405-411"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5011_archive_entity{
    .id = "SML5011",
    .name = "archive-entity",
    .severity = Severity::warning,
    .summary = "An entity is a .zsmurf, .zsmurfs or .zsmurfa archive.",
    .why = "The tools of this project read the archive without unpacking it.",
    .remedy = "For MARS, unpack the archive and name the .smurf or .smurfs inside it.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5011_archive_entity_file
