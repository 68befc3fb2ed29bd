// SPDX-License-Identifier: BSD-3-Clause
#include "schema/case_file.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "ast/model_reader.hpp"
#include "ast/scene_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf::test {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kShapeRules[] = {"SML2011", "SML4001", "SML4002",
                                            "SML4003", "SML4004", "SML5002"};

/// Infinities and NaN, which JSON lacks, stay text.
Json scalar(yaml::View value) {
  switch (value.type()) {
  case yaml::ScalarType::null: return nullptr;
  case yaml::ScalarType::boolean: return *value.boolean();
  case yaml::ScalarType::integer:
  case yaml::ScalarType::number:
    if (const auto integer = value.integer()) return *integer;
    if (const auto number = value.number(); number && std::isfinite(*number)) return *number;
    break;
  case yaml::ScalarType::text: break;
  }
  return std::string(value.text());
}

/// The first of two equal keys counts, as in MARS.
Json to_json(yaml::View value) {
  if (!value || value.is_null()) return nullptr;
  if (value.is_scalar()) return scalar(value);
  Json json = value.is_mapping() ? Json::object() : Json::array();
  for (const yaml::View child : value) {
    if (!value.is_mapping()) {
      json.push_back(to_json(child));
    } else if (const std::string key(child.key()); !json.contains(key)) {
      json[key] = to_json(child);
    }
  }
  return json;
}

std::string schema_of(FileKind kind) {
  switch (kind) {
  case FileKind::model: return "smurf.schema.json";
  case FileKind::annotations: return "annotations.schema.json";
  case FileKind::scene: return "smurfs.schema.json";
  }
  return "";
}

}  // namespace

std::optional<FileKind> kind_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".smurf") return FileKind::model;
  if (extension == ".smurfs" || extension == ".smurfa") return FileKind::scene;
  if (extension == ".yml") return FileKind::annotations;
  return std::nullopt;
}

Reading::Reading(FileKind kind, std::string text) {
  const SourceId id = sources.add("case", std::move(text));
  DiagnosticSink syntax;
  document = parse_yaml(sources, id, {}, syntax);
  if (!document) return;
  switch (kind) {
  case FileKind::model: read_model(*document, sink); break;
  case FileKind::annotations: read_annotations(*document, sink); break;
  case FileKind::scene: read_scene(*document, sink); break;
  }
}

std::vector<const Diagnostic*> Reading::shape_findings() const {
  std::vector<const Diagnostic*> findings;
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    // Schemas do not state the largest number: it would be two lines for each key.
    if (diagnostic.message.ends_with("too large to compute with")) continue;
    const auto* const end = std::end(kShapeRules);
    if (std::find(std::begin(kShapeRules), end, diagnostic.rule->id) != end) {
      findings.push_back(&diagnostic);
    }
  }
  return findings;
}

bool CaseFile::add(FileKind kind, std::string text) {
  const Reading reading(kind, text);
  if (!reading.document) return false;
  const Json instance = to_json(reading.document->view());
  instances_.push_back(
      {schema_of(kind), instance.dump(-1, ' ', true, Json::error_handler_t::replace)});
  const auto findings = reading.shape_findings();
  valid_count_ += findings.empty();
  cases_.push_back({std::move(text), findings.empty(), ""});
  for (const Diagnostic* finding : findings) {
    cases_.back().findings += std::string(finding->rule->id) + " " + finding->message + "; ";
  }
  return true;
}

std::optional<std::vector<std::string>> CaseFile::disagreements() const {
  const auto verdicts = validate(instances_);
  if (!verdicts) return std::nullopt;
  std::vector<std::string> result;
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    const bool is_valid = (*verdicts)[i];
    if (is_valid == cases_[i].is_valid) continue;
    result.push_back(cases_[i].text +
                     "\nreaders: " + (is_valid ? cases_[i].findings : std::string("valid")) +
                     "\nschema: " + (is_valid ? "valid" : "invalid"));
  }
  return result;
}

}  // namespace smurf::test
