// SPDX-License-Identifier: BSD-3-Clause
// Fixes that rename keys.
#pragma once

#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Renames keys of one mapping, but never to a key that exists or that another fix creates.
/// Searches the keys once, because every key of a mapping may be misspelt.
class KeyRenames {
 public:
  explicit KeyRenames(yaml::View mapping) : mapping_(mapping) {}

  bool has(std::string_view name);
  /// The mapping does not have the key, and no fix creates it.
  bool is_free(std::string_view name) { return !has(name) && !offered_.contains(name); }
  /// Adds a fix that renames `key` of the mapping, if the new name is free. Keeps the quotes of the
  /// key. The name must outlive this object.
  void offer(std::vector<Fix>& fixes, yaml::View key, std::string_view name);

 private:
  yaml::View mapping_;
  std::optional<std::set<std::string_view>> keys_;
  std::set<std::string_view> offered_;
};

}  // namespace smurf
