// SPDX-License-Identifier: BSD-3-Clause
// What a program will make of a file that is about to be written: the same verdict as that of
// `smurf-lint --target`, before the file is there.
#pragma once

#include <string>
#include <vector>

#include "smurf/check.hpp"
#include "smurf/readers.hpp"

namespace smurf {

struct ReaderVerdict {
  /// "refuses the mesh (SML1911 at /robot/link[1]/...)"; each once.
  std::vector<std::string> refused, lost;
};

/// Checks the file at `path`, as `files` has it.
ReaderVerdict verdict_on(const std::string& path, const Reader& reader, const FileReader& files,
                         const Limits& limits, const std::map<std::string, std::string>& packages);

}  // namespace smurf
