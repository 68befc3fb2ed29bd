// SPDX-License-Identifier: BSD-3-Clause
// Compares two versions of a model or a scene: the robots, not the text of the files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"
#include "smurf/pose.hpp"
#include "smurf/render.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// How diff() compares values.
struct DiffOptions {
  /// Values that differ by at most this are equal. Absolute for metres, radians and numbers without
  /// a unit; relative to the larger value for masses, inertias, efforts and all others.
  double tolerance = 1e-9;
  /// Compares the contents of meshes, textures and other files. Null: files are equal when their
  /// names are.
  const FileReader* files = nullptr;
  Limits limits = {};
};

enum class Change : std::uint8_t { added, removed, renamed, changed };
std::string_view to_string(Change change);

/// A value as it is compared; empty when it is absent.
using DiffValue = std::variant<std::monostate, bool, double, std::string, std::vector<double>, Pose,
                               Quaternion, std::vector<std::string>>;

/// One difference. Names are those of the new version; removed things have their old names.
struct Difference {
  Change change = Change::changed;
  std::string kind{};                         ///< "joint"; empty: the file as a whole
  std::string name{};                         ///< may be empty
  std::string owner{};                        ///< the parent: "link hand"; may be empty
  std::string old_name{};                     ///< old name of a renamed thing
  std::string property{};                     ///< the changed property: "limit.upper"
  DiffValue before{}, after{};                ///< of the property
  std::string_view fallback{};                ///< the value that readers use when it is absent
  std::string_view unit{};                    ///< may be empty
  std::span<const std::string_view> parts{};  ///< names of the numbers in the values; may be empty
  std::string detail{};                       ///< "moves 7 links"; may be empty
  std::size_t number = 0;  ///< number (from 1) among several things without a name
  /// Its place, or where it would be; none if its element or entry is not in that version.
  std::optional<Span> old_place{}, new_place{};
  /// The compared models, by their index in both scenes, or 0 when two models are compared; none
  /// for differences of the scene itself.
  std::optional<ModelIndex> old_model{}, new_model{};
};

/// The differences in the order of the new version, followed by removed things. Both versions must
/// be loaded into `sources`. Formatting, order, comments, and values that equal the default are
/// ignored. If only one of the models has annotations, only the robots are compared. With more
/// than Limits::differences, the comparison is incomplete, and the result exceeds the limit.
std::vector<Difference> diff(const LinkedModel& before, const LinkedModel& after,
                             const SourceMap& sources, const DiffOptions& options = {});
/// Compares two scenes, and the models that both have under one name.
std::vector<Difference> diff(const LinkedScene& before, const LinkedScene& after,
                             const SourceMap& sources, const DiffOptions& options = {});

/// The names of the compared versions, for reports.
struct DiffInputs {
  std::string before, after;
  double tolerance = 0;
};

/// One paragraph per difference, at most 80 columns or the width of the terminal, and a line with
/// the count.
std::string render_diff(std::span<const Difference> differences, const SourceMap& sources,
                        const TextStyle& style = {});
/// The report described by schemas/diff-report.schema.json.
std::string render_diff_json(std::span<const Difference> differences, const SourceMap& sources,
                             const DiffInputs& inputs, const ToolName& tool);
/// A self-contained HTML page with all differences, which can be searched and filtered. `picture`
/// is the result of write_both_versions(), or empty for a page without a 3D view.
std::string render_diff_html(std::span<const Difference> differences, const SourceMap& sources,
                             const DiffInputs& inputs, const ToolName& tool,
                             std::string_view picture);

}  // namespace smurf
