// SPDX-License-Identifier: BSD-3-Clause
// The findings of linking a scene.
#include "base/rules.hpp"

namespace smurf::rules {

constinit const Rule sml5005_entity_without_file{
    .id = "SML5005",
    .name = "entity-without-file",
    .severity = Severity::error,
    .summary = "An entity does not say what it stands for.",
    .why =
        "Without `file` and `type` MARS stops with an uncaught exception; with a file that has no "
        "extension it finds no type and leaves the entity out.",
    .remedy =
        "Add `file:` with the model or scene, and `type:` when the extension does not tell it.",
    .sources = "MARS SMURFLoader.cpp:315-322."};

constinit const Rule sml5006_missing_entity_file{
    .id = "SML5006",
    .name = "missing-entity-file",
    .severity = Severity::error,
    .summary = "An entity names a file that cannot be read.",
    .why = "MARS parses the missing file and stops with an uncaught exception (model, scene) or "
           "leaves the entity out (old scenes).",
    .remedy =
        "Correct the path; it is relative to the folder of the scene that contains the entity.",
    .sources = "MARS SMURFLoader.cpp:324-349; configmaps (run)."};

constinit const Rule sml5008_scene_extension{
    .id = "SML5008",
    .name = "scene-extension",
    .severity = Severity::error,
    .summary = "An entity of type smurfs or smurfa names a file with another extension.",
    .why =
        "In MARS the type selects the scene loader, which then reads nothing unless the file ends "
        "in .smurfs or .smurfa, and reports success.",
    .remedy = "Rename the scene file, or correct `type`.",
    .sources = "MARS SMURFLoader.cpp:350-418."};

constinit const Rule sml5009_entity_type_mismatch{
    .id = "SML5009",
    .name = "entity-type-mismatch",
    .severity = Severity::error,
    .summary = "The type of an entity and the extension of its file disagree.",
    .why =
        "MARS goes by the type and parses a URDF as YAML or a .smurf as XML; MARS 2 and Phobos go "
        "by the extension.",
    .remedy = "Leave `type` out, or make it smurf for a .smurf and urdf for a .urdf.",
    .sources = "MARS smurf.cpp:192-236; MarsSceneLoader.cpp:206-226; Phobos multiple.py:83-88."};

constinit const Rule sml5020_cyclic_include{
    .id = "SML5020",
    .name = "cyclic-include",
    .severity = Severity::error,
    .summary = "A scene includes itself, directly or through others.",
    .why = "MARS recurses until its stack overflows; Phobos stops with a RecursionError.",
    .remedy = "Take one include out of the circle; the notes name its files.",
    .sources = "MARS SMURFLoader.cpp:350-380; Phobos multiple.py."};

constinit const Rule sml5021_nested_too_deep{
    .id = "SML5021",
    .name = "nested-too-deep",
    .severity = Severity::error,
    .summary = "Scenes are nested deeper than the limit.",
    .why = "Readers recurse once per level and a hostile file could exhaust their stack.",
    .remedy = "Include the inner scenes directly.",
    .sources = "Limit of these tools."};

constinit const Rule sml5022_too_many_instances{
    .id = "SML5022",
    .name = "too-many-instances",
    .severity = Severity::error,
    .summary = "A scene expands to more entities, or to more text, than the limit.",
    .why = "Scenes that include others several times grow exponentially with their depth, and a "
           "large model is written out for each entity.",
    .remedy = "Split the scene, or raise the limit (docs/limits.md).",
    .sources = "Limit of these tools."};

constinit const Rule sml5101_unknown_parent{
    .id = "SML5101",
    .name = "unknown-parent",
    .severity = Severity::error,
    .summary = "`parent` names a frame that the scene does not have.",
    .why =
        "MARS prints a message and places the entity relative to the world. Without `::` it takes "
        "the whole text for an entity and never finds it.",
    .remedy =
        "Write `ENTITY::LINK` with the name of an entity and of a link of its model, or leave "
        "the key out for the world.",
    .sources = "MARS SimEntity.cpp:368-390."};

constinit const Rule sml5102_unknown_anchor{
    .id = "SML5102",
    .name = "unknown-anchor",
    .severity = Severity::error,
    .summary = "`anchor` is not none, world, parent, or a link of the scene.",
    .why = "MARS prints a message and fixes the entity to the world, whatever the text is (`None`, "
           "`false`, a misspelt entity).",
    .remedy = "Write `none`, `world`, `parent` or `ENTITY::LINK`.",
    .sources = "MARS SimEntity.cpp:447-481."};

constinit const Rule sml5103_parent_of_scene{
    .id = "SML5103",
    .name = "parent-of-scene",
    .severity = Severity::error,
    .summary = "`parent` or `anchor` names an included scene.",
    .why = "An include is no entity: MARS puts the entities of the scene in its place and does not "
           "find the name.",
    .remedy = "Name an entity inside the included scene and one of its links.",
    .sources = "MARS SMURFLoader.cpp:350-380."};

constinit const Rule sml5104_cyclic_parent{
    .id = "SML5104",
    .name = "cyclic-parent",
    .severity = Severity::error,
    .summary = "Entities are placed relative to each other in a circle.",
    .why = "No placement satisfies it. MARS creates them in file order, the first one relative to "
           "the world.",
    .remedy = "Place one of them relative to the world or to another entity.",
    .sources = "MARS SMURFLoader.cpp:580-637 (run)."};

constinit const Rule sml5105_unknown_pose{
    .id = "SML5105",
    .name = "unknown-pose",
    .severity = Severity::error,
    .summary = "`pose` names a joint pose set that the model does not have.",
    .why = "MARS leaves all joints at zero and says nothing; MARS 2 logs an error.",
    .remedy = "Correct the name, or add the set to the section `poses` of the model.",
    .sources = "MARS SimEntity.cpp:503-513; MarsSceneLoader.cpp:342."};

constinit const Rule sml5106_world_case{
    .id = "SML5106",
    .name = "world-case",
    .severity = Severity::warning,
    .summary = "`world` or `none` is written with capital letters.",
    .why =
        "Phobos 2 writes WORLD and means the world. MARS compares the words exactly, looks for an "
        "entity of that name, and does not move the entity along with an include.",
    .remedy = "Write `world` or `none`.",
    .sources = "MARS SimEntity.cpp:368-371, SMURFLoader.cpp:671-672; Phobos multiple.py:20,126."};

constinit const Rule sml5107_anchor_to_itself{
    .id = "SML5107",
    .name = "anchor-to-itself",
    .severity = Severity::error,
    .summary = "An entity is anchored to one of its own links.",
    .why =
        "MARS joins the root link and that link by a fixed joint, which blocks every joint between "
        "them.",
    .remedy = "Anchor the entity to the world or to another entity.",
    .sources = "MARS SimEntity.cpp:444-501."};

}  // namespace smurf::rules
