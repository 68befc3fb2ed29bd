// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/obj_materials.hpp"

#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "mesh/mesh_reader.hpp"
#include "mesh/words.hpp"

namespace smurf {
namespace {

/// What a library says of one material.
struct ObjMaterial {
  std::string name;
  std::optional<Rgba> color;
  double opacity = 1;
};

/// "0.8 0.2 0.1"; none for other notations, such as `spectral` or `xyz`.
std::optional<Rgba> color_in(std::string_view line) {
  Words words(line);
  Rgba color{0, 0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view word = words.next();
    const auto number = parse_number(word);
    // A single number is a grey.
    if (!number && word.empty() && i > 0) {
      color[i] = color[0];
      continue;
    }
    if (!number) return std::nullopt;
    color[i] = std::clamp(*number, 0.0, 1.0);
  }
  return color;
}

std::optional<double> share_in(std::string_view line) {
  Words words(line);
  std::string_view word = words.next();
  if (word == "-halo") word = words.next();
  const auto number = parse_number(word);
  return number ? std::optional(std::clamp(*number, 0.0, 1.0)) : std::nullopt;
}

}  // namespace

/// A line that was joined from several lines is not contained in the text.
MeshDependency mesh_dependency(std::string_view text, std::string_view name,
                               MeshDependency::Kind kind, std::uint32_t line) {
  const std::less<> is_before;
  const bool is_there = !is_before(name.data(), text.data()) &&
                        !is_before(text.data() + text.size(), name.data() + name.size());
  return {.filename = std::string(name),
          .kind = kind,
          .line = line,
          .offset = is_there ? static_cast<std::uint64_t>(name.data() - text.data()) : 0,
          .length = is_there ? name.size() : 0};
}

void ObjMaterials::read(std::string_view library) {
  if (!neighbours_ || !libraries_.emplace(library).second) return;
  const MeshDependency dependency{.filename = std::string(library)};
  const std::string text = neighbours_(dependency.path()).text;
  has_textures_ = has_textures_ || !read_material_library(text).empty();
  ObjMaterial material;
  const auto finish = [&] {
    if (material.color) (*material.color)[3] = material.opacity;
    if (!material.name.empty()) colors_.emplace(std::move(material.name), material.color);
  };
  Words words(text);
  while (!words.is_at_end()) {
    const std::string_view keyword = words.next();
    const std::string_view line = words.rest_of_line();
    if (keyword == "newmtl") {
      finish();
      material = {.name = std::string(line), .color = {}};
    } else if (keyword == "Kd") {
      material.color = color_in(line);
    } else if (keyword == "d") {
      material.opacity = share_in(line).value_or(material.opacity);
    } else if (keyword == "Tr") {
      // Exporters that invert the meaning write 1 for an opaque material; nothing is invisible.
      const double opacity = 1 - share_in(line).value_or(0);
      if (opacity > 0) material.opacity = opacity;
    }
  }
  finish();
}

std::optional<Rgba> ObjMaterials::color_of(std::string_view material) const {
  const auto known = colors_.find(material);
  return known == colors_.end() ? std::nullopt : known->second;
}

std::vector<MeshDependency> read_material_library(std::string_view text) {
  std::vector<MeshDependency> textures;
  Words words(text);
  while (!words.is_at_end()) {
    const std::string_view keyword = words.next();
    const std::uint32_t line = words.line();
    std::string_view rest = words.rest_of_line();
    const bool is_map = keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" ||
                        keyword == "decal" || keyword == "norm" || keyword == "refl";
    // Options (-s 1 1 1) come first and have any number of values; such lines are not supported.
    if (!is_map || rest.empty() || rest.front() == '-') continue;
    textures.push_back(mesh_dependency(text, rest, MeshDependency::Kind::texture, line));
  }
  return textures;
}

}  // namespace smurf
