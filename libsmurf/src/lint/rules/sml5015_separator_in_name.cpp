// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5015_separator_in_name_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (!entity.name || entity.name->find("::") == std::string::npos) return;
    findings.report(entity.name.span, "the name " + quoted(*entity.name) +
                                          " contains `::`, which separates entity and link");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "splits at the first `::`", "MARS SimEntity.cpp:373-376"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5015_separator_in_name{
    .id = "SML5015",
    .name = "separator-in-name",
    .severity = Severity::warning,
    .summary = "The name of an entity contains `::`.",
    .why =
        "`parent` and `anchor` are split at the first `::`, so other entities cannot refer to it.",
    .remedy = "Use another separator.",
    .sources = "MARS SimEntity.cpp:373-376.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5015_separator_in_name_file
