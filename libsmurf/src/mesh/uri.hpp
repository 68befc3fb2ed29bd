// SPDX-License-Identifier: BSD-3-Clause
// Names of files that are written as addresses.
#pragma once

#include <string>
#include <string_view>

namespace smurf {

/// `%20` is a blank, and so on for all bytes.
std::string decoded_uri(std::string_view uri);

}  // namespace smurf
