// SPDX-License-Identifier: BSD-3-Clause
// Which models are fixed to the world while a scene is written, and how they stand on a floor.
#pragma once

#include <vector>

#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// Changes a scene for the time of its life.
class Bases {
 public:
  explicit Bases(LinkedScene& scene) : scene_(scene) {}
  Bases(const Bases&) = delete;
  Bases& operator=(const Bases&) = delete;
  ~Bases();

  void anchor(BaseChoice choice) { anchored_ = anchor_bases(scene_, choice); }
  /// Lifts a single model onto the floor, and reports models of a scene that are below it. `flat`
  /// is that of `written`.
  void stand_on_floor(FlatScene& flat, const SceneExport& written);

 private:
  LinkedScene& scene_;
  std::vector<std::size_t> anchored_;
  double lift_ = 0;  ///< of the only instance, m
};

}  // namespace smurf::tools
