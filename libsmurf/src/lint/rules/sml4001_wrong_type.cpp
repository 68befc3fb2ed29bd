// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules::sml4001_wrong_type_file {
namespace {

using enum Effect;

constexpr std::string_view kEnds = "ends with an uncaught exception";
constexpr std::string_view kUnread = "does not read the section";
constexpr std::string_view kMakesRoom =
    "reads uninitialised memory, makes room for as many values, and ends";
constexpr std::string_view kRaises = "raises an exception";

constexpr Fact kFacts[] = {
    {&readers::mars, ignores, "reads only the requested pose", kRun, "/poses/#entry-single"},
    {&readers::mars, refuses, kEnds, kRun, "/submechanisms/#section-text"},
    {&readers::mars, refuses, kEnds, kRun, "/submechanisms/#section-blank"},
    {&readers::mars, refuses, kEnds, kRun, "#entry-nothing"},
    {&readers::mars, refuses, kEnds, kRun, "#names-nothing"},
    {&readers::mars, ignores, kUnread, kRun, "/submechanisms/"},
    {&readers::mars, ignores, kUnread, kRun, "/links/#entry-"},
    {&readers::mars, ignores, kUnread, kRun, "/joints/#entry-"},
    {&readers::mars, ignores, kUnread, kRun, "/collisions/#entry-"},
    {&readers::mars, ignores, "does not read it", kRun, "/date/"},
    {&readers::mars, ignores, "does not read it", kRun, "/description/"},
    {&readers::mars, ignores, "does not read it", kRun, "/SMURF version/"},
    {&readers::mars, refuses, kEnds, kRun, "/physics/#mapping-single"},
    {&readers::mars, refuses, kEnds, kRun, "/physics/ode/#mapping-single"},
    {&readers::mars, refuses, kMakesRoom, kRun, "/sensors/width/#value-blank"},
    {&readers::mars, ignores, "does not read it", kRun, "/modelname/"},
    {&readers::mars, ignores, "does not read it", kRun, "/collision/link/"},
    {&readers::mars, ignores, "does not read it", kRun, "/visuals/link/"},
    {&readers::mars, ignores, "does not read it", kRun, "/depth_image/"},
    {&readers::mars, ignores, "does not read it", kRun, "/springDamping/"},
    {&readers::mars, ignores, "does not read it", kRun, "/springStiffness/"},
    {&readers::mars, takes, "reads a mapping as the only entity", kRun, "#entity-only"},
    {&readers::mars, refuses, kEnds, kRun, "#entity-"},
    {&readers::mars, loses, "finds no entry in it", kRun, "#section-mapping"},
    {&readers::mars, refuses, kEnds, kRun, "#section-"},
    {&readers::mars, refuses, kEnds, kRun, "#entry-"},
    {&readers::mars, ignores, "reads only the joints of the requested pose", kRun, "/joints/"},
    {&readers::mars, refuses, kEnds, kRun, "#value-mapping"},
    {&readers::mars, refuses, kEnds, kRun, "#value-empty"},
    {&readers::mars, changes, "uses the first item of the list", kRun, "#value-list"},
    {&readers::mars, changes, "uses the first item of the list", kRun, "#value-single"},
    {&readers::mars, takes, "reads it as if it had no quotes", kRun, "#value-quoted"},
    {&readers::mars, breaks, "reads uninitialised memory", "configmaps ConfigAtom.hpp:83-91, run",
     "#value-"},
    {&readers::mars, refuses, kEnds, kRun, "#names-mapping"},
    {&readers::mars, changes, "uses the value as the only name", kRun, "#names-"},
    {&readers::mars, breaks, "reads only as many numbers as it needs", kRun, "#numbers-list"},
    {&readers::mars, breaks, "reads only as many numbers as it needs", kRun, "#numbers-single"},
    {&readers::mars, breaks, "reads only as many numbers as it needs", kRun, "#numbers-empty"},
    {&readers::mars, refuses, kEnds, kRun, "#numbers-"},
    {&readers::mars, changes, "uses the first item of the list", kRun, "#mapping-single"},
    {&readers::mars, refuses, kEnds, kRun, "#mapping-"},
    {&readers::phobos, refuses, kRaises, kRun, "#entity-"},
    {&readers::phobos, ignores, "does not read it", kRun, "/physics/"},
    {&readers::phobos, ignores, "does not read it", kRun, "/environment/"},
    {&readers::phobos, ignores, "treats an empty text as an empty list", kRun, "#section-blank"},
    {&readers::phobos, ignores, "keeps it as text", kRun, "/lights/"},
    {&readers::phobos, ignores, "keeps it as text", kRun, "/nodes/"},
    {&readers::phobos, ignores, "keeps it as text", kRun, "/graphics/"},
    {&readers::phobos, refuses, kRaises, kRun, "#section-"},
    {&readers::phobos, refuses, kRaises, kRun, "#entry-"},
    {&readers::phobos, takes, "accepts a list as well", kRun, "/ambientColor/#mapping-list"},
    {&readers::phobos, takes, "accepts a list as well", kRun, "/specularColor/#mapping-list"},
    {&readers::phobos, takes, "accepts a list as well", kRun, "/emissionColor/#mapping-list"},
    {&readers::phobos, takes, "accepts a list as well", kRun, "/orientation_offset/#mapping-list"},
    {&readers::phobos, ignores, "reads no joints", kRun, "/joints/#mapping-empty"},
    {&readers::phobos, refuses, kRaises, kRun, "/sensors/link/"},
    {&readers::phobos, refuses, kRaises, kRun, "/contextual_name/"},
    {&readers::phobos, refuses, kRaises, kRun, "/smurfs/file/"},
    {&readers::phobos, refuses, kRaises, kRun, "/entities/file/"},
    {&readers::phobos, refuses, kRaises, kRun, "/smurfs/anchor/"},
    {&readers::phobos, refuses, kRaises, kRun, "/entities/anchor/"},
    {&readers::phobos, refuses, kRaises, kRun, "/smurfs/parent/#value-mapping"},
    {&readers::phobos, refuses, kRaises, kRun, "/entities/parent/#value-mapping"},
    {&readers::phobos, ignores, "keeps the value as it is", kRun, "/joint/name/#value-mapping"},
    {&readers::phobos, ignores, "keeps the value as it is", kRun, "/link/name/#value-mapping"},
    {&readers::phobos, refuses, kRaises, kRun, "/joint/name/"},
    {&readers::phobos, refuses, kRaises, kRun, "/link/name/"},
    {&readers::phobos, refuses, kRaises, kRun, "/ambientColor/"},
    {&readers::phobos, refuses, kRaises, kRun, "/specularColor/"},
    {&readers::phobos, refuses, kRaises, kRun, "/emissionColor/"},
    {&readers::phobos, refuses, kRaises, kRun, "/position_offset/"},
    {&readers::phobos, refuses, kRaises, kRun, "/orientation_offset/"},
    {&readers::phobos, refuses, kRaises, kRun, "/position/"},
    {&readers::phobos, refuses, kRaises, kRun, "/rotation/"},
    {&readers::phobos, refuses, kRaises, kRun, "/joints/#mapping-"},
    {&readers::phobos, refuses, kRaises, kRun, "#names-"},
    {&readers::phobos, refuses, kRaises, kRun, "/motors/name/"},
    {&readers::phobos, refuses, kRaises, kRun, "/motors/joint/"},
    {&readers::phobos, refuses, kRaises, kRun, "/sensors/name/"},
    {&readers::phobos, refuses, kRaises, kRun, "/sensors/type/"},
    {&readers::phobos, refuses, kRaises, kRun, "/collision/name/"},
    {&readers::phobos, refuses, kRaises, kRun, "/poses/name/"},
    {&readers::phobos, refuses, kRaises, kRun, "/smurfs/name/"},
    {&readers::phobos, refuses, kRaises, kRun, "/entities/name/"},
    {&readers::phobos, ignores, "keeps the value as it is", kRun},
};
constexpr std::string_view kFormer[] = {"SML5001", "entities-not-a-list"};

}  // namespace

extern constinit const Rule sml4001_wrong_type{
    .id = "SML4001",
    .name = "wrong-type",
    .severity = Severity::error,
    .summary = "A key has a value of the wrong kind.",
    .why = "`yes`, `abc` and `.inf` are texts, not numbers or booleans.",
    .remedy =
        "Write a value of the kind that the message names; `smurf-lint --explain SECTION` lists "
        "the keys of a section with their types.",
    .facts = kFacts,
    .former = kFormer};

}  // namespace smurf::rules::sml4001_wrong_type_file
