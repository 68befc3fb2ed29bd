// SPDX-License-Identifier: BSD-3-Clause
#include "ast/key_renames.hpp"
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5007_entity_uri_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    if (!entity.uri || (entity.file && !entity.file->empty())) return;
    const yaml::View mapping(*file.document, entity.node);
    const yaml::View key = mapping.find("URI");
    Diagnostic& diagnostic = findings.report(
        key.key_span(), title(entity) + " names its file by `URI`, which MARS replaces by the "
                                        "file's contents");
    diagnostic.help("write `file`");
    KeyRenames(mapping).offer(diagnostic.fixes, key, "file");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "MARS SMURFLoader.cpp:315-322"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5007_entity_uri{
    .id = "SML5007",
    .name = "entity-uri",
    .severity = Severity::error,
    .summary = "An entity names its file by `URI` instead of `file`.",
    .remedy = "Write `file` instead of `URI`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5007_entity_uri_file
