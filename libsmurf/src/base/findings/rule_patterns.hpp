// SPDX-License-Identifier: BSD-3-Clause
// Rules as users name them: by id, by name, or by a prefix of several ids ("SML3").
#pragma once

#include <span>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// The rules that match; empty if the pattern matches no rule. The time does not depend on the
/// number of rules, because there may be any number of patterns.
std::span<const Rule* const> rules_matching(std::string_view pattern);

}  // namespace smurf
