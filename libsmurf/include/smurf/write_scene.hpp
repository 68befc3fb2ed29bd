// SPDX-License-Identifier: BSD-3-Clause
// Flat scenes as text in the formats of other programs.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {

/// How a format that can do both refers to models: by their files, or written out.
enum class SceneForm : std::uint8_t { reference, expand };

/// Where the meshes and textures of a preview come from. Files are relative to the output's folder.
struct MeshSource {
  /// Reads a mesh; null when there are no meshes. A writer calls it once for each file and kind,
  /// because it keeps nothing.
  std::function<MeshTriangles(const std::string& file, TexturePoints texture_points)> triangles;
  /// Equal for names of one file that have the same triangles.
  std::function<std::string(const std::string& file)> identity;
  /// Null when no image is at hand.
  std::function<FileContent(const std::string& file)> image;
  std::uint64_t most_bytes = Limits{}.scene_bytes;    ///< of all meshes, and of all images
  std::uint64_t most_pixels = Limits{}.image_pixels;  ///< of all images
};

/// What a writer is given. Everything must outlive the call.
struct SceneExport {
  const FlatScene& flat;
  const LinkedScene& scene;  ///< what `flat` was made of: instances are the same, in the same order
  const SourceMap& sources;  ///< what `scene` was read from
  DiagnosticSink& losses;    ///< receives what the format cannot express (SML82xx)
  bool links = false;  ///< write the world poses of all links, where there is a place for them
  SceneForm form = SceneForm::expand;
  bool ground = false;        ///< add a floor at z = 0; SceneFormat::has_ground
  bool names_copies = false;  ///< the files of models in `flat` are copies that will be made
  MeshSource meshes = {};     ///< for previews; when there is none, meshes are lost
  /// Limit of the text. A longer text is of no use and may end anywhere.
  std::uint64_t most_bytes = Limits{}.scene_bytes;
};

/// A format is one file in src/write that defines one of these, and its line in
/// src/write/scene_formats.def.
struct SceneFormat {
  std::string_view name;  ///< of --format
  std::string_view help;
  /// Instances without a pose, which only scenes with errors have, are left out.
  std::string (*write)(const SceneExport& scene) = nullptr;
  /// What its reader needs beside the result: a file name and its text.
  std::pair<std::string_view, std::string_view> companion = {};
  bool has_reference_form = false;
  bool has_expanded_form = true;
  bool has_ground = false;      ///< can add a floor to the expanded form
  bool repeats_models = false;  ///< writes the model of each instance out
  /// What check_scene_size() counts before anything is written; null when nothing is repeated.
  RepeatedParts (*repeated_parts)(const LinkedModel& model) = nullptr;
  /// Why this build cannot write it, and what to do; empty when it can. Null: every build can.
  std::string_view (*obstacle)() = nullptr;
};

std::span<const SceneFormat* const> scene_formats();
/// Null when there is none of that name.
const SceneFormat* find_scene_format(std::string_view name);

/// The page of the format html with two versions of a scene over each other. Both were flattened
/// for the same folder; meshes and limits are those of `after`. Empty when the page would be too
/// large, and in a build without the viewer.
std::string write_both_versions(const SceneExport& before, const SceneExport& after);

}  // namespace smurf
