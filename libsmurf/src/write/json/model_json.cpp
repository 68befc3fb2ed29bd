// SPDX-License-Identifier: BSD-3-Clause
// A model with its annotations: sections in the order of their table, entries in that of the files.
#include "write/json/model_json.hpp"

#include <array>
#include <utility>

#include "ast/sections.hpp"
#include "smurf/write.hpp"
#include "write/json/yaml_json.hpp"

namespace smurf {
namespace {

using Layout = JsonPrinter::Layout;

class ModelPrinter {
 public:
  ModelPrinter(JsonPrinter& json, const LinkedModel& model, const SourceMap& sources)
      : json_(json), model_(model), sources_(sources) {}

  void print() {
    json_.begin_object(Layout::block);
    json_.member("path", model_.path);
    print_field(json_, "modelname", model_.main.modelname);
    print_field(json_, "version", model_.main.version);
    if (model_.robot) print_field(json_, "robot", model_.robot->name);
    if (!model_.urdf_path.empty()) {
      json_.member("urdf", model_.urdf_path);
    }
    json_.key("is_complete");
    json_.boolean(model_.is_complete);
    files();
    print_robot(json_, model_, sources_);
    annotations();
    json_.key("custom");
    print_custom(json_, model_.annotations.custom, model_, sources_);
    json_.key("extra");
    print_custom(json_, model_.main.extra, model_, sources_);
    json_.end();
  }

 private:
  void files() {
    static constexpr std::array<std::string_view, 3> kKinds = {"main", "urdf", "annotation"};
    json_.key("files");
    json_.begin_list(Layout::block);
    for (const ModelFile& file : model_.files) {
      json_.begin_object();
      json_.member("path", sources_.path(file.source));
      json_.member("kind", kKinds[static_cast<std::size_t>(file.kind)]);
      json_.end();
    }
    json_.end();
  }

  void annotations() {
    json_.key("annotations");
    json_.begin_object(Layout::block);
    for (const SectionSpec* section : all_sections()) {
      const std::vector<const Annotation*> entries = section->list.entries(model_.annotations);
      if (entries.empty()) continue;
      const std::vector<const KeySpec*> keys = section->keys();
      json_.key(section->name);
      json_.begin_list(Layout::block);
      for (const Annotation* entry : entries) {
        if (json_.is_full()) break;
        print_entry(*section, *entry, keys);
      }
      json_.end();
    }
    json_.end();
  }

  void print_entry(const SectionSpec& section, const Annotation& entry,
                   std::span<const KeySpec* const> keys) {
    json_.begin_object();
    if (section.form == SectionForm::named) print_field(json_, "name", entry.name);
    json_.key("source");
    json_.place(entry.span, sources_);
    if (const yaml::Document* document = model_.document(entry.span.source)) {
      json_.key("values");
      print_typed(json_, {*document, entry.node}, keys);
    }
    json_.end();
  }

  JsonPrinter& json_;
  const LinkedModel& model_;
  const SourceMap& sources_;
};

}  // namespace

void print_custom(JsonPrinter& json, const std::vector<CustomSection>& sections,
                  const LinkedModel& model, const SourceMap& sources) {
  json.begin_list(Layout::block);
  for (const CustomSection& section : sections) {
    const yaml::Document* document = model.document(section.name.span.source);
    json.begin_object();
    json.member("name", section.name.value);
    json.key("source");
    json.place(section.name.span, sources);
    json.key("value");
    if (document != nullptr) {
      print_untyped(json, {*document, section.node});
    } else {
      json.null();
    }
    json.end();
  }
  json.end();
}

void print_model(JsonPrinter& json, const LinkedModel& model, const SourceMap& sources) {
  ModelPrinter(json, model, sources).print();
}

std::optional<std::string> write_model_json(const LinkedModel& model, const SourceMap& sources,
                                            std::uint64_t most) {
  JsonPrinter json(most);
  json.begin_object(Layout::block);
  json.member("schema_version", "1.0");
  json.key("model");
  print_model(json, model, sources);
  json.end();
  return json.take();
}

}  // namespace smurf
