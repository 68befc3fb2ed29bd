// SPDX-License-Identifier: BSD-3-Clause
// JSON Schemas (draft-07) of a user's own annotation sections and entity types.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/findings.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

struct UserSchema;

/// Limits the total work of checks by schemas in one model or scene, so that many small values cost
/// no more than a large value.
struct SchemaWork {
  std::int64_t steps = 100'000;  ///< a checked value adds steps in proportion to its size
};

/// Schemas of custom sections and entity types. With LoadContext, they are applied when the rules
/// run, and their names count as known. Their SourceMap must outlive them.
class UserSchemas {
 public:
  UserSchemas();
  ~UserSchemas();
  UserSchemas(UserSchemas&&) noexcept;
  UserSchemas& operator=(UserSchemas&&) noexcept;

  /// Registers the schema in the text `schema` (JSON or YAML) for the annotation section `name`, in
  /// models and in the data files of entities. Reports a broken schema and returns false; the name
  /// still counts as known.
  bool add_section(std::string name, SourceId schema, const SourceMap& sources,
                   DiagnosticSink& sink);
  /// The same for the entities of a type; the schema describes all keys of the entity.
  bool add_entity_type(std::string type, SourceId schema, const SourceMap& sources,
                       DiagnosticSink& sink);

  /// The names with a schema.
  std::vector<std::string_view> sections() const { return names_of(sections_); }
  std::vector<std::string_view> entity_types() const { return names_of(entity_types_); }
  bool has_section(std::string_view name) const { return sections_.contains(name); }
  bool has_entity_type(std::string_view type) const { return entity_types_.contains(type); }

  /// Reports violations of the schema for the value; nothing if there is no schema. The section is
  /// named by the value's key.
  void check_section(yaml::View value, SchemaWork& work, Findings& findings) const;
  void check_entity(std::string_view type, yaml::View entity, SchemaWork& work,
                    Findings& findings) const;

 private:
  using Table = std::map<std::string, std::unique_ptr<const UserSchema>, std::less<>>;
  static bool add(Table& table, std::string name, SourceId schema, const SourceMap& sources,
                  DiagnosticSink& sink);
  static std::vector<std::string_view> names_of(const Table& table);

  Table sections_, entity_types_;  ///< null for a broken schema
};

}  // namespace smurf
