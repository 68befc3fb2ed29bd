// SPDX-License-Identifier: BSD-3-Clause
// What a flat scene can be written as.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/flatten.hpp"

namespace smurf::tools {

struct SceneFormat {
  std::string_view name;
  std::string_view help;
  std::string (*write)(const FlatScene& scene, bool links) = nullptr;
  /// What the format cannot say of this scene, a sentence each; null when it can say everything.
  std::vector<std::string> (*losses)(const FlatScene& scene) = nullptr;
};

std::span<const SceneFormat> scene_formats();
/// Null when there is none of that name.
const SceneFormat* find_scene_format(std::string_view name);

}  // namespace smurf::tools
