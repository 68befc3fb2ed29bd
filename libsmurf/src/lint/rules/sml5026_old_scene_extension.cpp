// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5026_old_scene_extension_file {
namespace {

constexpr std::string_view kExtensions[] = {".scn", ".scene", ".yml"};

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (!is_old_scene(entity_type(entity)) || !entity.file || entity.file->empty()) return;
    const std::string_view extension = path::extension(*entity.file);
    if (std::find(std::begin(kExtensions), std::end(kExtensions), extension) !=
        std::end(kExtensions)) {
      return;
    }
    findings.report(entity.file.span,
                    "MARS has no loader of old scenes for " +
                        (extension.empty() ? "a file without extension"
                                           : "files ending in " + quoted(extension)));
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "calls a loader that does not exist",
     "MARS SMURFLoader.cpp:342"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5026_old_scene_extension{
    .id = "SML5026",
    .name = "old-scene-extension",
    .severity = Severity::error,
    .summary = "An entity of type scn, scene or yml names a file with another extension.",
    .remedy = "Rename the file to .scn, .scene or .yml, or correct `type`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5026_old_scene_extension_file
