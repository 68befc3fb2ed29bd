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

/// Renames keys of one mapping, never to a key that it has already or gets by another fix of these.
/// Its keys are searched once, because every key of a mapping may be misspelt.
class KeyRenames {
 public:
  explicit KeyRenames(yaml::View mapping) : mapping_(mapping) {}

  bool has(std::string_view name);
  /// The mapping does not have it, and it was not offered.
  bool is_free(std::string_view name) { return !has(name) && !offered_.contains(name); }
  /// Adds the fix that calls `key`, which is one of the mapping, by a name that is free; none when
  /// it is not. Quotes of the key are kept. The name must outlive this object.
  void offer(std::vector<Fix>& fixes, yaml::View key, std::string_view name);

 private:
  yaml::View mapping_;
  std::optional<std::set<std::string_view>> keys_;
  std::set<std::string_view> offered_;
};

}  // namespace smurf
