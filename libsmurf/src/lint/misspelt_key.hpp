// SPDX-License-Identifier: BSD-3-Clause
// Finds keys of scenes that are misspellings of known keys.
#pragma once

#include <span>
#include <string_view>

#include "ast/key_renames.hpp"
#include "ast/keys.hpp"

namespace smurf {

/// The keys under which a scene lists entities.
inline constexpr std::string_view kEntityLists[] = {"entities", "smurfs", "smurfa"};

bool takes_value(const KeySpec& spec, yaml::View value);

/// The key of `keys` that an unknown key of the mapping of `renames` probably means: it is similar,
/// absent, and accepts the value. Null if there is none.
const KeySpec* misspelt_key(yaml::View value, KeyRenames& renames, std::span<const KeySpec> keys);

}  // namespace smurf
