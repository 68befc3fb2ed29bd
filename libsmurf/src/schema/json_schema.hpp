// SPDX-License-Identifier: BSD-3-Clause
// Applies a checked schema to a value.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "schema/checked_schema.hpp"

namespace smurf {

/// A keyword that a value violates.
struct SchemaFault {
  std::vector<yaml::View> path;     ///< from the checked value to the one at fault
  std::vector<yaml::View> schemas;  ///< that apply to it, outer ones first; the last is violated
  Keyword keyword = Keyword::never;
  yaml::View keyword_value;   ///< in the schema
  std::string_view name;      ///< the missing key
  bool fits_several = false;  ///< one_of
  std::vector<SchemaFault>
      forms;  ///< what is wrong with the forms of any_of or one_of; the last few
};

/// Subtracts its cost from the steps, of about 1 us each. If they do not suffice, returns none and
/// sets them to 0.
std::optional<std::vector<SchemaFault>> apply_schema(const CheckedSchema& schema, yaml::View value,
                                                     std::int64_t& steps_left);

}  // namespace smurf
