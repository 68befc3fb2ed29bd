// SPDX-License-Identifier: BSD-3-Clause
// How a finding about a limit ends.
#pragma once

#include <string>
#include <string_view>

namespace smurf {

/// `name` is that of a row of kLimits.
inline std::string raise_limit(std::string_view name) {
  return "raise the limit with `--limit " + std::string(name) + "=N`";
}

}  // namespace smurf
