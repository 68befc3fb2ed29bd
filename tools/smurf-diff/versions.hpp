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
struct InputVersion {
  std::string path;           ///< the path to load
  std::string shown;          ///< name in messages
  std::string replaced = {};  ///< the file whose text is replaced; "": none
  std::string text = {};
  XacroSettings xacro = {};
};

/// Puts the text of a version in its place while it is loaded. Others may be loaded there later.
class ReplacedText {
 public:
  ReplacedText(Session& session, const InputVersion& version)
      : session_(session), replaced_(version.replaced) {
    if (!replaced_.empty()) session_.set_text(replaced_, version.text);
  }
  ~ReplacedText() {
    if (!replaced_.empty()) session_.clear_text(replaced_);
  }
  ReplacedText(const ReplacedText&) = delete;
  ReplacedText& operator=(const ReplacedText&) = delete;

 private:
  Session& session_;
  std::string replaced_;
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

Compared compare_versions(Session& session, const InputVersion& before, const InputVersion& after,
                          const Options& options);

}  // namespace smurf::tools
