// SPDX-License-Identifier: BSD-3-Clause
// --explain: prints rules, families of rules, sections and keys of the format.
#pragma once

#include <string>
#include <string_view>

#include "smurf/render.hpp"

namespace smurf::tools {

/// The page of a rule, the list of a family (SML31, 31), the keys of a section, or a key; "" if
/// `what` is not one of these.
std::string explanation(std::string_view what, const TextStyle& style);

/// The message for a word that explanation() does not know.
std::string nothing_to_explain(std::string_view what);

}  // namespace smurf::tools
