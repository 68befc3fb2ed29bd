// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/write_scene.hpp"

namespace smurf {

#define SMURF_SCENE_FORMAT(name)                                                                   \
  namespace name##_file {                                                                          \
    extern const SceneFormat name;                                                                 \
  }                                                                                                \
  using name##_file::name;
#include "write/scene_formats.def"
#undef SMURF_SCENE_FORMAT

namespace {

constexpr const SceneFormat* kFormats[] = {
#define SMURF_SCENE_FORMAT(name) &name,
#include "write/scene_formats.def"
#undef SMURF_SCENE_FORMAT
};

}  // namespace

std::span<const SceneFormat* const> scene_formats() { return kFormats; }

const SceneFormat* find_scene_format(std::string_view name) {
  for (const SceneFormat* format : kFormats) {
    if (format->name == name) return format;
  }
  return nullptr;
}

}  // namespace smurf
