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

/// `path` as seen from `folder`, both looked up in the file system; "" when it lies elsewhere.
std::string path_inside(const std::string& path, const std::string& folder,
                        const CanonicalPaths& paths);

}  // namespace smurf
