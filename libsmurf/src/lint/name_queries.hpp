// SPDX-License-Identifier: BSD-3-Clause
// Faults of the names of links and joints, other than being unknown.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "lint/queries.hpp"

namespace smurf {

/// The most severe fault first: each name is reported once.
enum class NameFault : std::uint8_t {
  none,
  blank,         ///< begins or ends with one
  slash,         ///< holds `/`
  double_colon,  ///< holds `::`
  reserved,      ///< `__name__`, which sdformat keeps for itself
  non_ascii,
  irregular  ///< no identifier: other characters than letters, digits and `_`, or a digit in front
};
NameFault name_fault(std::string_view name);

/// Calls `visit` with "link" or "joint" for every name that is written and not empty.
void for_each_name(const LinkedModel& model,
                   const std::function<void(std::string_view, const Field<std::string>&)>& visit);

/// The first link without a name, or with one that xacro was to make. Null when all have one.
const urdf::Link* link_without_name(const LinkedModel& model);

/// Reports a joint, `who`, that names a link which the robot does not have. Where a link has no
/// name
/// (`unnamed`, else null), that is the fault: null is returned then.
Diagnostic* check_link_of_joint(const LinkedModel& model, const Reference& link,
                                const std::string& who, const urdf::Link* unnamed,
                                Findings& findings);

/// The name that Isaac and USD use: `_` for what is no letter, digit or underscore, and `a_` before
/// a digit or underscore in front.
std::string as_identifier(std::string_view name);

/// Different names of links, or of joints, that become equal.
struct NameCollision {
  std::string_view kind;  ///< "link" or "joint"
  const Field<std::string>* first = nullptr;
  const Field<std::string>* second = nullptr;
};
/// Returns the pairs of names that become equal after `fold`.
std::vector<NameCollision>
name_collisions(const LinkedModel& model, const std::function<std::string(std::string_view)>& fold);

}  // namespace smurf
