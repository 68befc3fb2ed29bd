// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/formats.hpp"

#include "base/files/path.hpp"
#include "base/text/lists.hpp"
#include "render/wrap.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

std::vector<std::string_view> format_names() {
  std::vector<std::string_view> names;
  for (const SceneFormat* format : scene_formats()) names.push_back(format->name);
  return names;
}

std::string format_help() {
  return "Choose the output format: " + listed(format_names()) +
         "; `help` describes them. By default, that of the extension of --output, or json.";
}

std::string formats_page() {
  constexpr std::size_t kIndent = 10;
  constexpr std::size_t kColumns = 80;
  std::string page = "Output formats:\n\n";
  for (const SceneFormat* format : scene_formats()) {
    std::string head = "  " + std::string(format->name);
    head.resize(kIndent, ' ');
    page += head + render::wrap(format->help, kIndent, kColumns).substr(kIndent);
  }
  return page;
}

std::string format_hint(std::string_view value) {
  constexpr std::size_t kShortest = 3;
  if (value.size() < kShortest) return {};
  for (const SceneFormat* format : scene_formats()) {
    if (path::to_lower(format->help).find(path::to_lower(value)) == std::string::npos) continue;
    return "; did you mean '" + std::string(format->name) + "'?";
  }
  return {};
}

std::string_view advice_on(std::string_view extension) {
  if (extension == ".usd" || extension == ".usdc") {
    return "smurfs-flatten writes OpenUSD as text: name a .usda file";
  }
  if (extension == ".glb") return "smurfs-flatten writes glTF as text: name a .gltf file";
  if (extension == ".xml") return "for MuJoCo, add --format mjcf";
  return "add --format";
}

}  // namespace smurf::tools
