// SPDX-License-Identifier: BSD-3-Clause
// Values of YAML files as properties, typed by the rows of the key tables.
#pragma once

#include <map>
#include <memory>
#include <span>

#include "ast/keys.hpp"
#include "diff/properties.hpp"
#include "smurf/limits.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Reads values, and knows the defaults of the rows.
class YamlProperties {
 public:
  using Rows = std::span<const KeySpec* const>;

  /// The members of a mapping for which `is_wanted` is true; null: all.
  Property mapping(std::string_view key, yaml::View value, Rows rows,
                   bool (*is_wanted)(std::string_view key) = nullptr);
  /// A value by its row; without one, by the YAML 1.2 core schema.
  Property value(std::string_view key, yaml::View value, const KeySpec* row);

 private:
  Property typed(const KeySpec& row, yaml::View value);
  Property untyped(std::string_view key, yaml::View value);
  Property list(std::string_view key, yaml::View value, KeyTable members);
  Property components(const KeySpec& row, yaml::View value);
  const Property& fallback_of(const KeySpec& row);

  std::map<const KeySpec*, Property> fallbacks_;
};

}  // namespace smurf
