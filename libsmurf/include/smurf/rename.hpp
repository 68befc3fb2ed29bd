// SPDX-License-Identifier: BSD-3-Clause
// Renames things in every place that names them.
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
  std::optional<NameKind> kind;  ///< none: the kind of the only thing of this name
  std::string from, to;
};

/// The result of rename().
struct Renamed {
  std::vector<FixedText> texts;       ///< changed files only, sorted by path
  std::vector<Edit> edits;            ///< the same changes, one by one
  std::vector<std::string> problems;  ///< the reason why nothing is changed; `texts` is then empty
};

/// Renames in all loaded files: each of `loaded` is the result of references_of() for a model or a
/// scene. All renames happen at once, so two things can swap their names. A problem is reported if
/// nothing has the name, if several things have it, or if the new name is taken.
Renamed rename(std::span<const std::vector<Reference>> loaded, std::span<const Rename> renames,
               const SourceMap& sources);

/// Differences in meaning after loading the renamed files again: "arm.yml:3:5: ...". Empty if every
/// name refers to the same thing.
std::vector<std::string> changed_meanings(std::span<const std::vector<Reference>> before,
                                          std::span<const std::vector<Reference>> after,
                                          const SourceMap& sources);

}  // namespace smurf
