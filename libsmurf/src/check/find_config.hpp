// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "smurf/check.hpp"

namespace smurf {

/// The configuration for a file or folder: the one that the settings name, else the nearest upward.
/// "" when there is none.
std::string find_config(const std::string& path, const CheckSettings& settings,
                        const FileReader& files);

}  // namespace smurf
