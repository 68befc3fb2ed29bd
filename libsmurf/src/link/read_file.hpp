// SPDX-License-Identifier: BSD-3-Clause
// Files into sources and trees.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "smurf/load.hpp"

namespace smurf {

/// Reads a file into the source map. If it cannot be read, reports `rule` at `reference` (the text
/// that names the file; empty for a path of the command line) and returns none. The message
/// suggests a file with a similar name, unless `is_taken` returns true for it.
std::optional<SourceId> read_source(const std::string& path, Span reference, const Rule& rule,
                                    LoadContext& context,
                                    const std::function<bool(const std::string&)>& is_taken = {});

/// The first of `names` with the same extension and a similar stem that `may_be` accepts.
std::optional<std::string> similar_name(std::string_view name, std::span<const std::string> names,
                                        const std::function<bool(const std::string&)>& may_be);

/// Similar names in the file's folder, for "did you mean", except for names that cannot be
/// written and paths for which `is_taken` is true. None if many findings of the rule were
/// reported before.
std::optional<std::string>
similar_file(const std::string& path, const Rule& rule, const LoadContext& context,
             const std::function<bool(const std::string&)>& is_taken = {});

}  // namespace smurf
