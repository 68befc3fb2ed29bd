// SPDX-License-Identifier: BSD-3-Clause
// A loaded scene as the text of a format.
#pragma once

#include <optional>
#include <string>

#include "common/asset_copies.hpp"
#include "smurf/check.hpp"
#include "smurf/dialect.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// How a scene is written.
struct SceneWishes {
  const SceneFormat& format;
  SceneForm form = SceneForm::expand;
  const Dialect& dialect = *dialects().front();
  std::optional<BaseChoice> base = {};
  bool ground = false;
  bool links = false;
  std::string assets = {};  ///< folder for the files that the result names; "": they stay
  std::string output_folder = ".";
  std::string current_folder = {};  ///< absolute
};

struct WrittenScene {
  std::string text;  ///< empty: `found` says why
  AssetCopies copies;
  bool has_falling_robots = false;
};

/// Losses are added to `found`. The scene is left as it was, at the same places in memory.
WrittenScene write_scene(LoadedScene& loaded, const SceneWishes& wishes, const FileReader& files,
                         const Limits& limits, DiagnosticSink& found);

/// Whether a finding is about something that the result lacks. Added values are not losses.
bool is_loss(const Diagnostic& finding);

/// The form that a format writes unless a user asks for another one.
SceneForm usual_form(const SceneFormat& format);
bool has_form(const SceneFormat& format, SceneForm form);

}  // namespace smurf::tools
