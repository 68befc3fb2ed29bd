// SPDX-License-Identifier: BSD-3-Clause
// Values of YAML files as properties, typed by the rows of the key tables.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>

#include "ast/keys.hpp"
#include "diff/properties.hpp"
#include "smurf/limits.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Reads values and knows their defaults.
class YamlProperties {
 public:
  using Rows = std::span<const KeySpec* const>;

  /// The members of a mapping for which `is_wanted` is true; null: all.
  Property mapping(std::string_view key, yaml::View value, Rows rows,
                   bool (*is_wanted)(std::string_view key) = nullptr);
  /// Reads a value by its row; without a row, by the YAML 1.2 core schema.
  Property value(std::string_view key, yaml::View value, const KeySpec* row);

 private:
  Property typed(const KeySpec& row, yaml::View value);
  Property untyped(std::string_view key, yaml::View value);
  /// A list whose items are texts, even if they look like numbers.
  Property list_of_names(std::string_view key, yaml::View value);
  Property list(std::string_view key, yaml::View value, KeyTable members);
  Property components(const KeySpec& row, yaml::View value);
  const Property& fallback_of(const KeySpec& row);

  /// A default, and the text that it points into.
  struct Fallback {
    SourceMap sources;
    std::optional<yaml::Document> document;
    Property value;
  };
  std::map<const KeySpec*, Fallback> fallbacks_;
};

}  // namespace smurf
