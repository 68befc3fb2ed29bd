// SPDX-License-Identifier: BSD-3-Clause
// Faults of whole Drake elements, which a table of elements and attributes cannot describe: Drake
// refuses or ignores such an element.
#pragma once

#include "lint/drake_queries.hpp"

namespace smurf::drake {

/// Elements that Drake ignores while it loads the file.
inline constexpr Circumstance kUnread{"unread"};
inline constexpr Circumstance kTooShort{"too short"};

/// Reports faults that the table of Drake's language does not cover.
void check_meaning(xml::View element, const Names& names, Findings& findings);

/// Whether a joint of this type has such an element.
bool is_read_in(xml::View joint, std::string_view child);

}  // namespace smurf::drake
