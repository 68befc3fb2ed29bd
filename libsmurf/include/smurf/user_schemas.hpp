// SPDX-License-Identifier: BSD-3-Clause
// JSON Schemas (draft-07) of a user's own annotation sections and entity types.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/lint.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

struct UserSchema;

/// Limits the total work of checking values by schemas, so that many small values cost no more than
/// a large one. For one model or scene.
struct SchemaWork {
  std::int64_t steps = 100'000;  ///< each value adds some for its size
};

/// Schemas by what they are for. Given to LoadContext, they are applied when the rules run, and
/// what they name counts as known. The SourceMap they were read from must outlive them.
class UserSchemas {
 public:
  UserSchemas();
  ~UserSchemas();
  UserSchemas(UserSchemas&&) noexcept;
  UserSchemas& operator=(UserSchemas&&) noexcept;

  /// Registers the schema in the text `schema` (JSON or YAML) for the annotation section `name`, in
  /// models and in the data files of entities. False when it is broken, which is reported there;
  /// the name is then still known.
  bool add_section(std::string name, SourceId schema, const SourceMap& sources,
                   DiagnosticSink& sink);
  /// The same for the entities of a type; the schema describes all keys of the entity.
  bool add_entity_type(std::string type, SourceId schema, const SourceMap& sources,
                       DiagnosticSink& sink);

  /// The names that schemas are registered for.
  std::vector<std::string_view> sections() const { return names_of(sections_); }
  std::vector<std::string_view> entity_types() const { return names_of(entity_types_); }
  bool has_section(std::string_view name) const { return sections_.contains(name); }
  bool has_entity_type(std::string_view type) const { return entity_types_.contains(type); }

  /// Reports what the value breaks in its schema; nothing when there is no schema for it. The name
  /// of the section is the value's key.
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
