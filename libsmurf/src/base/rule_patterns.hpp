// SPDX-License-Identifier: BSD-3-Clause
// Rules as people name them: by id, by name, or several by what their ids begin with ("SML3").
#pragma once

#include <span>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Whether the rule has replaced one of this id or name.
bool has_former(const Rule& rule, std::string_view id_or_name);

/// The rules that match; none for a pattern that matches no rule. Takes the same time however many
/// rules there are, for there may be any number of patterns.
std::span<const Rule* const> rules_matching(std::string_view pattern);

}  // namespace smurf
