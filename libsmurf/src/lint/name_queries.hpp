// SPDX-License-Identifier: BSD-3-Clause
// Faults in the names of links and joints; unknown names are checked elsewhere.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "lint/queries.hpp"
#include "smurf/references.hpp"

namespace smurf {

/// The most severe fault first: each name is reported once.
enum class NameFault : std::uint8_t {
  none,
  blank,         ///< begins or ends with one
  slash,         ///< holds `/`
  double_colon,  ///< holds `::`
  reserved,      ///< `__name__`, which sdformat reserves
  non_ascii,
  irregular  ///< not an identifier: other characters than letters, digits and `_`, or a digit first
};
NameFault name_fault(std::string_view name);

struct Meanings;

/// Calls `visit` with "link" or "joint" for every name that is written and not empty.
void for_each_name(const LinkedModel& model,
                   const std::function<void(std::string_view, const Field<std::string>&)>& visit);

/// The first link without a name, or with an unexpanded xacro name. Null if there is none.
const urdf::Link* link_without_name(const LinkedModel& model);

/// Reports a joint, `who`, that names an unknown link. If some link has no
/// name (`unnamed`, otherwise null), that link is the fault; then returns
/// null.
Diagnostic* check_link_of_joint(const LinkedModel& model, const Reference& link,
                                const std::string& who, const urdf::Link* unnamed,
                                Findings& findings, const Meanings& meanings);

/// The name in Isaac and USD: `_` replaces characters other than letters, digits and underscores,
/// and `a_` is put before a leading digit or underscore.
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
