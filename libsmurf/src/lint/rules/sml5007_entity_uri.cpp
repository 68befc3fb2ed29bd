// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    if (!entity.uri || (entity.file && !entity.file->empty())) return;
    const yaml::View mapping(*file.document, entity.node);
    const Span key = mapping.find("URI").key_span();
    Diagnostic& diagnostic =
        findings.report(key, title(entity) + " names its file by `URI`, which MARS replaces by the "
                                             "file's contents");
    diagnostic.help = "write `file`";
    if (!entity.file.written) diagnostic.fixes.push_back({Applicability::unsafe, {{key, "file"}}});
  });
}

}  // namespace

extern constinit const Rule sml5007_entity_uri{
    .id = "SML5007",
    .name = "entity-uri",
    .severity = Severity::error,
    .summary = "An entity names its file by `URI` instead of `file`.",
    .why = "Scenes of Phobos 0.6 do. MARS replaces the key by the contents of that file before "
           "it looks for one, finds neither file nor type, and stops with an uncaught exception.",
    .remedy = "Write `file` instead of `URI`.",
    .sources = "MARS SMURFLoader.cpp:315-322, 420; configmaps ConfigMap.cpp:607-638 (run).",
    .check_scene = check};

}  // namespace smurf::rules
