// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/collada_texture.hpp"

#include <algorithm>

#include "base/numbers/numbers.hpp"

namespace smurf::collada {
namespace {

using xml::View;

/// The accessor of texture coordinates names S and T, or U and V, as its first two parameters.
std::vector<TexturePoint> read(View source) {
  constexpr std::int64_t kMost = 1 << 30;  // prevents an overflow of the conversion to size_t
  const View array = source.child("float_array");
  const View technique = source.child("technique_common");
  const View accessor = technique ? technique.child("accessor") : View();
  if (!array || !accessor) return {};
  const auto stride = parse_integer(value(accessor, "stride"));
  const auto offset = parse_integer(value(accessor, "offset"));
  const auto step =
      static_cast<std::size_t>(std::clamp<std::int64_t>(stride.value_or(2), 2, kMost));
  const auto first =
      static_cast<std::size_t>(std::clamp<std::int64_t>(offset.value_or(0), 0, kMost));
  const std::vector<double> all = numbers(array.text());
  std::vector<TexturePoint> points;
  for (std::size_t i = first; i + 2 <= all.size(); i += step) {
    points.push_back(texture_point(all[i], all[i + 1]));
  }
  return points;
}

}  // namespace

TextureSources::TextureSources(View mesh) {
  for (const View source : mesh) {
    if (source.name() == "source") by_id_.emplace(value(source, "id"), source);
  }
}

const std::vector<TexturePoint>* TextureSources::of(View input) {
  const auto found = by_id_.find(id_in(value(input, "source")));
  if (found == by_id_.end()) return nullptr;
  const auto [known, is_new] = read_.try_emplace(found->second.id());
  if (is_new) known->second = read(found->second);
  return &known->second;
}

void TexturedPoints::join(const std::vector<std::int64_t>& textures,
                          const std::vector<TexturePoint>& source,
                          std::vector<std::uint32_t>& corners, std::vector<Vector3>& points,
                          std::vector<TexturePoint>& texture_points) {
  if (source_ != &source) pairs_.clear();
  source_ = &source;
  texture_points.resize(points.size(), kNoTexturePoint);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::int64_t texture = textures[i];
    if (texture < 0 || static_cast<std::uint64_t>(texture) >= source.size()) continue;
    const std::uint64_t pair = static_cast<std::uint64_t>(texture) << 32U | corners[i];
    const auto [known, is_new] =
        pairs_.try_emplace(pair, static_cast<std::uint32_t>(points.size()));
    if (is_new) {
      points.push_back(points[corners[i]]);
      texture_points.push_back(source[static_cast<std::size_t>(texture)]);
    }
    corners[i] = known->second;
  }
}

}  // namespace smurf::collada
