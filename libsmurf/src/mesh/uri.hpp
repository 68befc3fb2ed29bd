// SPDX-License-Identifier: BSD-3-Clause
// File names that are written as URIs.
#pragma once

#include <string>
#include <string_view>

namespace smurf {

/// Decodes `%20` and other percent escapes.
std::string decoded_uri(std::string_view uri);

}  // namespace smurf
