// SPDX-License-Identifier: BSD-3-Clause
// One line a format.
#include "smurfs-flatten/formats.hpp"

#include "smurf/write.hpp"

namespace smurf::tools {
namespace {

constexpr SceneFormat kFormats[] = {
    {"json", "instances in the world frame, for programs", write_flat_json, nullptr},
};

}  // namespace

std::span<const SceneFormat> scene_formats() { return kFormats; }

const SceneFormat* find_scene_format(std::string_view name) {
  for (const SceneFormat& format : kFormats) {
    if (format.name == name) return &format;
  }
  return nullptr;
}

}  // namespace smurf::tools
