// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/canonical_paths.hpp"
#include "base/path.hpp"

namespace smurf {

/// Equal for two spellings of one file; links are resolved.
inline std::string identity(const std::string& path, const CanonicalPaths& paths) {
  return paths.of(path).value_or(path::normalize(path));
}

}  // namespace smurf
