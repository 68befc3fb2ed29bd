// SPDX-License-Identifier: BSD-3-Clause
#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5024_primitive_value_file {
namespace {

/// The colours and textures of the primitive, as in the section `materials`.
void check_material(yaml::View material, DiagnosticSink& found) {
  if (material.is_null()) return;
  if (!material.is_mapping()) {
    found.report(rules::sml4001_wrong_type, material.place(),
                 "`material` of a primitive must be a mapping, not " + describe(material));
    return;
  }
  for (const KeySpec* spec : sections::materials.keys()) {
    const yaml::View value = material.find(spec->name);
    if (value) read_value(*spec, value, {}, found);
  }
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    if (entity_type(entity) != "primitive") return;
    DiagnosticSink found;
    for (const yaml::View value : mapping_of(file, entity)) {
      if (value.is_repeated() || find_key({all_entity_keys()}, value.key())) continue;
      if (value.key() == "material") check_material(value, found);
      const KeySpec* spec = find_key({sections::node_keys()}, value.key());
      if (spec != nullptr) read_value(*spec, value, {}, found);
    }
    for (const Diagnostic& wrong : found.diagnostics()) {
      Diagnostic& diagnostic = findings.report(wrong.span, wrong.message);
      diagnostic.cases = wrong.cases;
      diagnostic.help(wrong.help_text);
      diagnostic.fixes = wrong.fixes;
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception", kRun,
     when(cases::kValueWanted, cases::kIsMapping)},
    {&readers::mars, Effect::crashes, "ends with an uncaught exception", kRun,
     when(cases::kValueWanted, cases::kIsEmptyList)},
    {&readers::mars, Effect::loses, "makes no node of such a size", kRun, at("extend/x")},
    {&readers::mars, Effect::loses, "makes no node of such a size", kRun, at("extend/y")},
    {&readers::mars, Effect::loses, "makes no node of such a size", kRun, at("extend/z")},
    {&readers::mars, Effect::changes, "reads 0 or any number", kRun, when(cases::kValueWanted)},
    {&readers::mars, Effect::crashes,
     "ends with an uncaught exception, or reads uninitialised memory", "MARS NodeData.cpp:181-184"},
};

}  // namespace

extern constinit const Rule sml5024_primitive_value{
    .id = "SML5024",
    .name = "primitive-value",
    .severity = Severity::error,
    .summary = "A key of a primitive has a value of a kind that MARS does not read.",
    .remedy = "Write the kind of value that the message names.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5024_primitive_value_file
