// SPDX-License-Identifier: BSD-3-Clause
// Two versions, loaded into the same sources and compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smurf-diff/options.hpp"
#include "smurf/check.hpp"
#include "smurf/diff.hpp"

namespace smurf::tools {

/// A file, and the text that one version has in its place.
struct Version {
  std::string path;           ///< what is loaded
  std::string shown;          ///< what it is called in messages
  std::string replaced = {};  ///< the file whose text is replaced; "": none
  std::string text = {};
};

struct Compared {
  std::vector<Difference> differences;
  /// Findings that prevent the comparison.
  std::vector<Diagnostic> trouble;
  /// Missing files without which the comparison is incomplete, but possible.
  std::vector<Diagnostic> remarks;
  std::string problem;  ///< in words; "": none

  bool is_known() const { return problem.empty() && trouble.empty(); }
};

Compared compare_versions(Session& session, const Version& before, const Version& after,
                          const Options& options);

}  // namespace smurf::tools
