// SPDX-License-Identifier: BSD-3-Clause
// Files into sources and trees.
#pragma once

#include <optional>
#include <string>

#include "smurf/load.hpp"

namespace smurf {

/// Reads a file into the source map. When it cannot be read, reports `rule` at `reference` (the
/// text that names the file; empty for a path of the command line) and returns none.
std::optional<SourceId> read_source(const std::string& path, Span reference, const Rule& rule,
                                    LoadContext& context);

/// Names in the file's folder that differ from it only in case or little else, for "did you mean",
/// unless they are no names that could be written. None when many findings of the rule were
/// reported before.
std::optional<std::string> similar_file(const std::string& path, const Rule& rule,
                                        const LoadContext& context);

}  // namespace smurf
