// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf::rules::sml4301_section_against_schema_file {
namespace {

void check_sections(const yaml::Document& document, const UserSchemas& schemas, SchemaWork& work,
                    Findings& findings) {
  const yaml::View root = document.view();
  if (!root || !root.is_mapping()) return;
  for (const yaml::View section : root) {
    if (!section.is_repeated()) schemas.check_section(section, work, findings);
  }
}

void check_model(const LinkedModel& model, Findings& findings) {
  if (model.schemas == nullptr) return;
  SchemaWork work;
  for (const ModelFile& file : model.files) {
    if (file.document) check_sections(*file.document, *model.schemas, work, findings);
  }
}

void check_scene(const LinkedScene& scene, Findings& findings) {
  if (scene.schemas == nullptr) return;
  SchemaWork work;
  for (const DataFile& file : scene.data_files) {
    check_sections(file.document, *scene.schemas, work, findings);
  }
}

}  // namespace

extern constinit const Rule sml4301_section_against_schema{
    .id = "SML4301",
    .name = "section-against-schema",
    .severity = Severity::error,
    .summary = "A section breaks the schema that was registered for it.",
    .why = "The schema describes the values that the reader of the section understands; the "
           "effect of other values is unknown.",
    .remedy = "Change the value, or the schema when it is too strict.",
    .sources = "The schema that the label names.",
    .check_model = check_model,
    .check_scene = check_scene};

}  // namespace smurf::rules::sml4301_section_against_schema_file
