// SPDX-License-Identifier: BSD-3-Clause
// Rules as people name them: by id, by name, or several by what their ids begin with ("SML3").
#pragma once

#include <span>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// The rules that match; none for a pattern that matches no rule. Takes the same time however many
/// rules there are, for there may be any number of patterns.
std::span<const Rule* const> rules_matching(std::string_view pattern);

}  // namespace smurf
