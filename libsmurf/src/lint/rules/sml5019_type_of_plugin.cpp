// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5019_type_of_plugin_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    const std::string type = entity_type(entity);
    const bool is_of_phobos =
        std::find(std::begin(kPhobosTypes), std::end(kPhobosTypes), type) != std::end(kPhobosTypes);
    const ModelType* model = model_type(type);
    const bool is_of_others = model != nullptr && !model->is_of_mars;
    if ((!is_of_phobos && !is_of_others) || has_schema(scene, type)) return;
    findings.report(type_place(entity), "MARS contains no plug-in for entities of type " +
                                            quoted(type) + " and leaves this entity out");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "leaves the entity out with a message",
     "MARS EntityFactoryManager.cpp:80-89"},
};

}  // namespace

extern constinit const Rule sml5019_type_of_plugin{
    .id = "SML5019",
    .name = "type-of-plugin",
    .severity = Severity::info,
    .summary = "An entity has a type that MARS does not know: an SDF, an MJCF, or one that Phobos "
               "writes.",
    .why = "A plug-in may add the type.",
    .remedy =
        "Load a plug-in for the type, or use `lights`, a primitive or a URDF instead. "
        "`smurf2urdf robot.sdf` and `smurf2urdf robot.xml` make a URDF; these tools read both "
        "as they are.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5019_type_of_plugin_file
