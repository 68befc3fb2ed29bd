// SPDX-License-Identifier: BSD-3-Clause
// The texts of a xacro document and of the files that belong to its robots.
#pragma once

#include <deque>
#include <string_view>

#include "common/xacro_text.hpp"
#include "smurf/source.hpp"

namespace smurf::lsp {

/// A document, the files that include it, and all files that these include.
struct XacroFamily {
  struct File {
    SourceId source{};
    tools::XacroText read;
  };
  SourceMap sources;
  std::deque<File> files;  ///< the first is the document

  std::string_view text(const File& file) const { return sources.text(file.source); }
};

}  // namespace smurf::lsp
