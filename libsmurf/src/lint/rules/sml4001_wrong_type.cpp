// SPDX-License-Identifier: BSD-3-Clause
#include "base/cases.hpp"
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
    {&readers::mars, ignores, "reads only the requested pose", kRun,
     at("poses").when(cases::kEntryWanted, cases::kIsSingle)},
    {&readers::mars, refuses, kEnds, kRun,
     at("submechanisms").when(cases::kSectionWanted, cases::kIsText)},
    {&readers::mars, refuses, kEnds, kRun,
     at("submechanisms").when(cases::kSectionWanted, cases::kIsBlank)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kEntryWanted, cases::kIsNothing)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kNamesWanted, cases::kIsNothing)},
    {&readers::mars, ignores, kUnread, kRun, at("submechanisms")},
    {&readers::mars, ignores, kUnread, kRun, at("links").when(cases::kEntryWanted)},
    {&readers::mars, ignores, kUnread, kRun, at("joints").when(cases::kEntryWanted)},
    {&readers::mars, ignores, kUnread, kRun, at("collisions").when(cases::kEntryWanted)},
    {&readers::mars, ignores, "does not read it", kRun, at("date")},
    {&readers::mars, ignores, "does not read it", kRun, at("description")},
    {&readers::mars, ignores, "does not read it", kRun, at("SMURF version")},
    {&readers::mars, refuses, kEnds, kRun,
     at("physics").when(cases::kMappingWanted, cases::kIsSingle)},
    {&readers::mars, refuses, kMakesRoom, kRun,
     at("sensors/width").when(cases::kValueWanted, cases::kIsBlank)},
    {&readers::mars, ignores, "does not read it", kRun, at("modelname")},
    {&readers::mars, ignores, "does not read it", kRun, at("collision/link")},
    {&readers::mars, ignores, "does not read it", kRun, at("visuals/link")},
    {&readers::mars, ignores, "does not read it", kRun, at("depth_image")},
    {&readers::mars, ignores, "does not read it", kRun, at("springDamping")},
    {&readers::mars, ignores, "does not read it", kRun, at("springStiffness")},
    {&readers::mars, takes, "reads a mapping as the only entity", kRun,
     when(cases::kEntityWanted, cases::kIsEntity)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kEntityWanted)},
    {&readers::mars, loses, "finds no entry in it", kRun,
     when(cases::kSectionWanted, cases::kIsMapping)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kSectionWanted)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kEntryWanted)},
    {&readers::mars, ignores, "reads only the joints of the requested pose", kRun, at("joints")},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kValueWanted, cases::kIsMapping)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kValueWanted, cases::kIsEmptyList)},
    {&readers::mars, changes, "uses the first item of the list", kRun,
     when(cases::kValueWanted, cases::kIsList)},
    {&readers::mars, changes, "uses the first item of the list", kRun,
     when(cases::kValueWanted, cases::kIsSingle)},
    {&readers::mars, takes, "reads it as if it had no quotes", kRun,
     when(cases::kValueWanted, cases::kIsQuoted)},
    {&readers::mars, breaks, "reads uninitialised memory", "configmaps ConfigAtom.hpp:83-91, run",
     when(cases::kValueWanted)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kNamesWanted, cases::kIsMapping)},
    {&readers::mars, changes, "uses the value as the only name", kRun, when(cases::kNamesWanted)},
    {&readers::mars, breaks, "reads only as many numbers as it needs", kRun,
     when(cases::kNumbersWanted, cases::kIsList)},
    {&readers::mars, breaks, "reads only as many numbers as it needs", kRun,
     when(cases::kNumbersWanted, cases::kIsSingle)},
    {&readers::mars, breaks, "reads only as many numbers as it needs", kRun,
     when(cases::kNumbersWanted, cases::kIsEmptyList)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kNumbersWanted)},
    {&readers::mars, changes, "uses the first item of the list", kRun,
     when(cases::kMappingWanted, cases::kIsSingle)},
    {&readers::mars, refuses, kEnds, kRun, when(cases::kMappingWanted)},
    {&readers::phobos, refuses, kRaises, kRun, when(cases::kEntityWanted)},
    {&readers::phobos, ignores, "does not read it", kRun, at("physics")},
    {&readers::phobos, ignores, "does not read it", kRun, at("environment")},
    {&readers::phobos, ignores, "treats an empty text as an empty list", kRun,
     when(cases::kSectionWanted, cases::kIsBlank)},
    {&readers::phobos, ignores, "keeps it as text", kRun, at("lights")},
    {&readers::phobos, ignores, "keeps it as text", kRun, at("nodes")},
    {&readers::phobos, ignores, "keeps it as text", kRun, at("graphics")},
    {&readers::phobos, refuses, kRaises, kRun, when(cases::kSectionWanted)},
    {&readers::phobos, refuses, kRaises, kRun, when(cases::kEntryWanted)},
    {&readers::phobos, takes, "accepts a list as well", kRun,
     at("ambientColor").when(cases::kMappingWanted, cases::kIsList).unless(cases::kHasItems)},
    {&readers::phobos, takes, "accepts a list as well", kRun,
     at("specularColor").when(cases::kMappingWanted, cases::kIsList).unless(cases::kHasItems)},
    {&readers::phobos, takes, "accepts a list as well", kRun,
     at("emissionColor").when(cases::kMappingWanted, cases::kIsList).unless(cases::kHasItems)},
    {&readers::phobos, takes, "accepts a list as well", kRun,
     at("orientation_offset").when(cases::kMappingWanted, cases::kIsList).unless(cases::kHasItems)},
    {&readers::phobos, ignores, "reads no joints", kRun,
     at("joints").when(cases::kMappingWanted, cases::kIsEmptyList)},
    {&readers::phobos, refuses, kRaises, kRun, at("sensors/link")},
    {&readers::phobos, refuses, kRaises, kRun, at("contextual_name")},
    {&readers::phobos, refuses, kRaises, kRun, at("smurfs/file")},
    {&readers::phobos, refuses, kRaises, kRun, at("entities/file")},
    {&readers::phobos, refuses, kRaises, kRun, at("smurfs/anchor")},
    {&readers::phobos, refuses, kRaises, kRun, at("entities/anchor")},
    {&readers::phobos, refuses, kRaises, kRun,
     at("smurfs/parent").when(cases::kValueWanted, cases::kIsMapping)},
    {&readers::phobos, refuses, kRaises, kRun,
     at("entities/parent").when(cases::kValueWanted, cases::kIsMapping)},
    {&readers::phobos, ignores, "keeps the value as it is", kRun,
     at("joint/name").when(cases::kValueWanted, cases::kIsMapping)},
    {&readers::phobos, ignores, "keeps the value as it is", kRun,
     at("link/name").when(cases::kValueWanted, cases::kIsMapping)},
    {&readers::phobos, refuses, kRaises, kRun, at("joint/name")},
    {&readers::phobos, refuses, kRaises, kRun, at("link/name")},
    {&readers::phobos, refuses, kRaises, kRun, at("ambientColor")},
    {&readers::phobos, refuses, kRaises, kRun, at("specularColor")},
    {&readers::phobos, refuses, kRaises, kRun, at("emissionColor")},
    {&readers::phobos, refuses, kRaises, kRun, at("position_offset")},
    {&readers::phobos, refuses, kRaises, kRun, at("orientation_offset")},
    {&readers::phobos, refuses, kRaises, kRun, at("position")},
    {&readers::phobos, refuses, kRaises, kRun, at("rotation")},
    {&readers::phobos, refuses, kRaises, kRun, at("joints").when(cases::kMappingWanted)},
    {&readers::phobos, refuses, kRaises, kRun, when(cases::kNamesWanted)},
    {&readers::phobos, refuses, kRaises, kRun, at("motors/name")},
    {&readers::phobos, refuses, kRaises, kRun, at("motors/joint")},
    {&readers::phobos, refuses, kRaises, kRun, at("sensors/name")},
    {&readers::phobos, refuses, kRaises, kRun, at("sensors/type")},
    {&readers::phobos, refuses, kRaises, kRun, at("collision/name")},
    {&readers::phobos, refuses, kRaises, kRun, at("poses/name")},
    {&readers::phobos, refuses, kRaises, kRun, at("smurfs/name")},
    {&readers::phobos, refuses, kRaises, kRun, at("entities/name")},
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
