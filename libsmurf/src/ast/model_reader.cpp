// SPDX-License-Identifier: BSD-3-Clause
// The main file and annotation files. Shape only: nothing is opened or looked up.
#include "ast/model_reader.hpp"

#include "ast/sections.hpp"
#include "base/rules.hpp"

namespace smurf {
namespace {

bool is_main_key(std::string_view key) {
  return key == "files" || key == "modelname" || key == "version";
}

/// YAML is a superset of JSON, so every file kind may hold anything; ours are mappings.
bool is_mapping(const yaml::Document& document, std::string_view what, DiagnosticSink& sink) {
  const yaml::View root = document.view();
  if (root && root.is_mapping()) return true;
  const Span place = root ? root.span() : Span{document.source, 0, 0};
  sink.report(rules::sml2011_root_not_mapping, place,
              "the " + std::string(what) + " holds " + (root ? describe(root) : "nothing") +
                  " instead of keys and values");
  return false;
}

/// MARS tolerates a single name in place of the list.
void read_files(yaml::View value, Model& model, DiagnosticSink& sink) {
  constexpr KeySpec kFiles{.name = "files", .type = ValueType::name_list};
  if (value.is_scalar()) {
    model.files = {NameList{{std::string(value.text()), value.span()}}, value.span(), true};
  } else {
    read_value(kFiles, value, &model.files, sink);
  }
}

}  // namespace

std::optional<Model> read_model(const yaml::Document& document, DiagnosticSink& sink) {
  if (!is_mapping(document, "main file", sink)) return std::nullopt;
  Model model;
  const yaml::View root = document.view();
  constexpr KeySpec kModelname{.name = "modelname", .type = ValueType::text};
  constexpr KeySpec kVersion{.name = "version", .type = ValueType::text};
  if (const yaml::View name = root.find("modelname")) {
    read_value(kModelname, name, &model.modelname, sink);
  }
  if (const yaml::View version = root.find("version")) {
    read_value(kVersion, version, &model.version, sink);
  }
  if (const yaml::View files = root.find("files")) read_files(files, model, sink);
  read_sections(root, is_main_key, model.inline_annotations, sink);
  model.extra = std::move(model.inline_annotations.custom);
  model.inline_annotations.custom.clear();
  return model;
}

std::optional<Annotations> read_annotations(const yaml::Document& document, DiagnosticSink& sink) {
  if (!is_mapping(document, "annotation file", sink)) return std::nullopt;
  Annotations annotations;
  read_sections(document.view(), [](std::string_view) { return false; }, annotations, sink);
  return annotations;
}

}  // namespace smurf

namespace smurf::rules {

constinit const Rule sml2011_root_not_mapping{
    .id = "SML2011",
    .name = "root-not-mapping",
    .severity = Severity::error,
    .summary = "A main, annotation or scene file is empty or does not hold a mapping.",
    .why = "configmaps (MARS) throws an uncaught exception on an empty file, a list or a text.",
    .remedy = "Write the keys of the file kind (`files:`, `motors:`, `entities:`), or take the file "
              "out of the list that names it.",
    .sources = "configmaps ConfigMap.cpp (run); smurf_parser SMURFParser.cpp:53-77 (run)."};

}  // namespace smurf::rules
