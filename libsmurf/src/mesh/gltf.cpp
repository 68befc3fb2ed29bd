// SPDX-License-Identifier: BSD-3-Clause
// The triangles of glTF 2.0.
#include "mesh/formats.hpp"
#include "mesh/gltf_scene.hpp"
#include <cmath>

namespace smurf {
namespace {

using namespace gltf;

/// Converts a linear amount of light to sRGB.
double screen_value(double light) {
  const double c = std::fmin(std::fmax(light, 0), 1);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

class GltfTriangles {
 public:
  GltfTriangles(Data& data, TriangleCollector& triangles) : data_(data), triangles_(triangles) {}

  void read() {
    visit_meshes(data_, [&](const Json& mesh, std::uint64_t, const Affine& X) {
      return visit_primitives(data_, mesh, steps_, [&](const Primitive& primitive) {
        triangles_.set_color(color_of(member(*primitive.written, "material")));
        if (!triangles_.wants_texture_points()) return add(primitive, std::nullopt, X);
        const auto textures = textures_of(*primitive.written);
        return data_.reason().empty() && add(primitive, textures, X);
      });
    });
  }

 private:
  /// The first texture coordinates of the points of a primitive.
  std::optional<Accessor> textures_of(const Json& primitive) {
    const Json* attributes = member(primitive, "attributes");
    const Json* index = attributes == nullptr ? nullptr : member(*attributes, "TEXCOORD_0");
    auto textures = index == nullptr ? std::nullopt : data_.accessor(index, "VEC2");
    if (textures && textures->type == kInt) {
      data_.fail_broken("texture coordinates are integers of four bytes");
    }
    return textures;
  }

  static TexturePoint texture_of(const std::optional<Accessor>& textures, std::uint64_t place) {
    if (!textures || place >= textures->count) return kNoTexturePoint;
    const auto [u, v] = textures->texture_point(place);
    return texture_point(u, 1 - v);  // glTF counts rows from above
  }

  bool add(const Primitive& primitive, const std::optional<Accessor>& textures, const Affine& X) {
    return visit_triangles(data_, primitive, X, [&](const Corners& corners) {
      TextureCorners places{};
      for (std::size_t k = 0; k < 3; ++k) {
        if (textures) places[k] = texture_of(textures, place_of(primitive, corners.places[k]));
      }
      if (!textures) places.fill(kNoTexturePoint);
      return triangles_.add(corners.points[0], corners.points[1], corners.points[2], places);
    });
  }

  /// None for a texture.
  std::optional<Rgba> color_of(const Json* index) {
    if (index == nullptr) return std::nullopt;
    const Json* material = data_.item("materials", index);
    const Json* pbr = material == nullptr ? nullptr : member(*material, "pbrMetallicRoughness");
    if (pbr == nullptr) return std::nullopt;
    if (member(*pbr, "baseColorTexture") != nullptr) {
      triangles_.note_textures();
      return std::nullopt;
    }
    Rgba color;
    if (!read_numbers(member(*pbr, "baseColorFactor"), color)) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) color[i] = screen_value(color[i]);
    const bool is_blended = is_text(member(*material, "alphaMode"), "BLEND");
    color[3] = is_blended ? std::fmin(std::fmax(color[3], 0), 1) : 1;
    return color;
  }

  Data& data_;
  TriangleCollector& triangles_;
  std::size_t steps_ = 0;
};

}  // namespace

std::string read_gltf_triangles(std::string_view bytes, const MeshNeighbours& neighbours,
                                TriangleCollector& triangles) {
  Data data(bytes, neighbours);
  if (data.reason().empty()) GltfTriangles(data, triangles).read();
  return data.reason();
}

}  // namespace smurf
