// SPDX-License-Identifier: BSD-3-Clause
// Zip archives, in memory. The only place that knows minizip.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/limits.hpp"

namespace smurf {

struct ArchivedFile {
  std::string path;  ///< relative, without ".."
  std::string text;
};

struct Archive {
  std::vector<ArchivedFile> files;  ///< sorted by path
  std::string reason;               ///< why it cannot be read, for a person; empty when it can
};

/// Unpacks an archive within the limits for archives. What names a place outside of the archive, is
/// encrypted or is broken makes all of it unreadable.
Archive read_zip(std::string_view bytes, const Limits& limits);

}  // namespace smurf
