// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/user_schemas.hpp"

#include <utility>

#include "base/findings/rules.hpp"
#include "schema/checked_schema.hpp"
#include "schema/json_schema.hpp"
#include "schema/violations.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {

struct UserSchema {
  yaml::Document document;
  CheckedSchema schema;
};

namespace {

/// Schemas that apply themselves to parts of a value several times double the work with every
/// level.
constexpr std::int64_t kStepsForValue = 4;

void report_limit(yaml::View value, std::string message, Findings& findings) {
  findings.report(value.key_span().empty() ? value.span() : value.key_span(), std::move(message))
      .severity = Severity::info;
}

void check(const UserSchema* schema, yaml::View value, SchemaWork& work, Findings& findings) {
  if (schema == nullptr || !value) return;
  const std::size_t size = size_of(value);
  work.steps += kStepsForValue * static_cast<std::int64_t>(size);
  const auto faults =
      size <= kLargest ? apply_schema(schema->schema, value, work.steps) : std::nullopt;
  if (!faults) {
    return report_limit(value, "this is too large to be checked by its schema", findings);
  }
  const std::vector<Violation> violations = explain(*faults, work.steps);
  if (work.steps <= 0) {
    report_limit(value, "this violates its schema in more places than are reported", findings);
  }
  for (const Violation& violation : violations) {
    Diagnostic& diagnostic = findings.report(violation.span, violation.message);
    diagnostic.help(violation.help);
    diagnostic.notes = violation.notes;
    diagnostic.fixes = violation.fixes;
    if (!violation.add_span.empty()) {
      diagnostic.label(violation.add_span, "add it after this key");
    }
    if (!violation.schema_span.empty()) {
      diagnostic.label(violation.schema_span, "required here by the schema");
    }
  }
}

template <class Table>
const UserSchema* find(const Table& table, std::string_view name) {
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second.get();
}

}  // namespace

UserSchemas::UserSchemas() = default;
UserSchemas::~UserSchemas() = default;
UserSchemas::UserSchemas(UserSchemas&&) noexcept = default;
UserSchemas& UserSchemas::operator=(UserSchemas&&) noexcept = default;

std::vector<std::string_view> UserSchemas::names_of(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& [name, schema] : table) names.emplace_back(name);
  return names;
}

bool UserSchemas::add(Table& table, std::string name, SourceId schema, const SourceMap& sources,
                      DiagnosticSink& sink) {
  std::unique_ptr<const UserSchema>& entry = table[std::move(name)];
  entry.reset();
  std::optional<yaml::Document> document = parse_yaml(sources, schema, Limits{}, sink);
  if (!document) return false;
  if (!document->view()) {
    sink.report(rules::sml9011_broken_schema, {schema, 0, 0}, "the schema is empty");
    return false;
  }
  // The checked schema points into the document, so the document has its final place first.
  auto registered = std::make_unique<UserSchema>(UserSchema{std::move(*document), {}});
  DiagnosticSink found;
  auto checked = check_schema(registered->document.view(), found);
  for (Diagnostic& diagnostic : found.take()) {
    diagnostic.pointer = yaml::pointer(registered->document,
                                       yaml::node_at(registered->document, diagnostic.span.begin));
    sink.report(*diagnostic.rule, diagnostic.span, {}) = std::move(diagnostic);
  }
  if (!checked) return false;
  registered->schema = *std::move(checked);
  entry = std::move(registered);
  return true;
}

bool UserSchemas::add_section(std::string name, SourceId schema, const SourceMap& sources,
                              DiagnosticSink& sink) {
  return add(sections_, std::move(name), schema, sources, sink);
}

bool UserSchemas::add_entity_type(std::string type, SourceId schema, const SourceMap& sources,
                                  DiagnosticSink& sink) {
  return add(entity_types_, std::move(type), schema, sources, sink);
}

void UserSchemas::check_section(yaml::View value, SchemaWork& work, Findings& findings) const {
  check(find(sections_, value.key()), value, work, findings);
}

void UserSchemas::check_entity(std::string_view type, yaml::View entity, SchemaWork& work,
                               Findings& findings) const {
  check(find(entity_types_, type), entity, work, findings);
}

}  // namespace smurf
