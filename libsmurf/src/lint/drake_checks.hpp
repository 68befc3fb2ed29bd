// SPDX-License-Identifier: BSD-3-Clause
// What Drake refuses, or does not read, in an element of its own as a whole: what no table of
// elements and attributes says.
#pragma once

#include "lint/drake_queries.hpp"

namespace smurf::drake {

/// The construct of elements that Drake ignores while it loads the file.
inline constexpr std::string_view kUnread = "unread";

/// Does nothing for elements without such faults.
void check_meaning(xml::View element, const Names& names, Findings& findings);

/// True when a joint of this type has such an element.
bool is_read_in(xml::View joint, std::string_view child);

}  // namespace smurf::drake
