// SPDX-License-Identifier: BSD-3-Clause
// New names for things, in every place that names them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/fix.hpp"
#include "smurf/names.hpp"
#include "smurf/references.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// A thing and its new name.
struct Rename {
  std::optional<NameKind> kind;  ///< none: that of the only thing of this name
  std::string from, to;
};

/// The result of rename().
struct Renamed {
  std::vector<FixedText> texts;       ///< changed files only, sorted by path
  std::vector<Edit> edits;            ///< the same, one by one
  std::vector<std::string> problems;  ///< why nothing is changed; `texts` is empty then
};

/// Renames in all that was loaded together: each of `loaded` is what references_of() finds in a
/// model or a scene. All renames happen at once, so that two things can swap their names. It is a
/// problem when nothing has the name, when several things have it, or when the new one is taken.
Renamed rename(std::span<const std::vector<Reference>> loaded, std::span<const Rename> renames,
               const SourceMap& sources);

/// Where the renamed files, loaded again, differ from before: "arm.yml:3:5: ...". Empty when every
/// name refers to the same thing.
std::vector<std::string> changed_meanings(std::span<const std::vector<Reference>> before,
                                          std::span<const std::vector<Reference>> after,
                                          const SourceMap& sources);

}  // namespace smurf
