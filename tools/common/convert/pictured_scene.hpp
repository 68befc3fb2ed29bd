// SPDX-License-Identifier: BSD-3-Clause
// Scenes for the pictures in pages of findings and differences.
#pragma once

#include <optional>
#include <string>

#include "smurf/check.hpp"
#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// A scene or model, loaded and flattened for the current folder. The session must outlive it.
class PicturedScene {
 public:
  /// `current` is the absolute path of the current folder.
  PicturedScene(Session& session, const std::string& path, const CheckSettings& settings,
                const std::string& current);
  /// A scene that was loaded with `files`, which must outlive it.
  PicturedScene(LoadedScene loaded, const FileReader& files, const Limits& limits,
                const std::string& current);
  PicturedScene(const PicturedScene&) = delete;
  PicturedScene& operator=(const PicturedScene&) = delete;

  /// The input of the writer, which refers to this object; none if the poses are unknown, or if the
  /// page would be too large to send.
  std::optional<SceneExport> to_write();
  /// What was loaded, with the findings of loading it.
  const LoadedScene& loaded() const { return loaded_; }
  LoadedScene& loaded() { return loaded_; }

 private:
  const FileReader& files_;
  Limits limits_;
  LoadedScene loaded_;
  FlattenOptions flattening_;
  FlatScene flat_;
};

/// The error that says best why a picture is not what its author wanted: the first one that keeps
/// robots from being built, or else the first one. Null if there is none.
const Diagnostic* first_error(const LoadedScene& loaded);
/// Whether only a part of the robot would be shown, because its file breaks off.
bool is_broken_off(const Diagnostic* error);

}  // namespace smurf::tools
