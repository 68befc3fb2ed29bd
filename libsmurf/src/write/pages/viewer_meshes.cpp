// SPDX-License-Identifier: BSD-3-Clause
#include "write/pages/viewer_meshes.hpp"

#include <limits>

#include "base/numbers/bits.hpp"
#include "write/text/base64.hpp"

namespace smurf {

/// The bytes of a point (three floats), of an index (at least two bytes) and of texture coordinates
/// (two floats), in base64.
constexpr PreviewMeshes::Cost kCost{16, 2, 10};

namespace {

template <std::size_t Size>
std::string floats_in_base64(const std::vector<std::array<float, Size>>& points) {
  std::string bytes;
  for (const std::array<float, Size>& point : points) {
    for (const float coordinate : point) append_bytes(bytes, bit_cast<std::uint32_t>(coordinate));
  }
  return base64(bytes);
}

}  // namespace

ViewerMeshes::ViewerMeshes(const SceneExport& scene, bool has_copies)
    : files_(scene, kCost), has_copies_(has_copies) {}

const ViewerMeshes::Known& ViewerMeshes::find(const std::string& file, Span place) {
  const std::string& first = files_.first_name(file);
  const auto [known, is_new] = known_.try_emplace(first);
  if (is_new) known->second = read(first, place, TexturePoints::ignored);
  return known->second;
}

const ViewerMeshes::Known& ViewerMeshes::find_textured(const std::string& file, Span place) {
  const std::string& first = files_.first_name(file);
  const auto [known, is_new] = textured_.try_emplace(first);
  if (is_new) known->second = read(first, place, TexturePoints::read);
  return known->second;
}

ViewerMeshes::Known ViewerMeshes::read(const std::string& file, Span place,
                                       TexturePoints texture_points) {
  const MeshTriangles mesh = files_.read(file, place, texture_points);
  if (!mesh.reason.empty()) return {std::nullopt, mesh.reason};
  if (texture_points == TexturePoints::read && mesh.texture_points.empty()) {
    return {std::nullopt, "has no texture coordinates"};
  }
  Known known = add(file, mesh);
  known.has_textures = mesh.has_textures;
  return known;
}

ViewerMeshes::Known ViewerMeshes::add(const std::string& file, const MeshTriangles& mesh) {
  Shown shown{.file = file,
              .points = floats_in_base64(mesh.points),
              .indices = {},
              .texture_points = floats_in_base64(mesh.texture_points),
              .parts = mesh.parts,
              .is_wide = mesh.points.size() > std::numeric_limits<std::uint16_t>::max()};
  std::string bytes;
  for (const std::uint32_t index : mesh.indices) {
    if (shown.is_wide) {
      append_bytes(bytes, index);
    } else {
      append_bytes(bytes, static_cast<std::uint16_t>(index));
    }
  }
  shown.indices = base64(bytes);
  for (std::size_t i = 0; has_copies_ && i < shown_.size(); ++i) {
    const Shown& other = shown_[i];
    if (other.points == shown.points && other.indices == shown.indices &&
        other.texture_points == shown.texture_points) {
      return {i, {}};
    }
  }
  shown_.push_back(std::move(shown));
  return {shown_.size() - 1, {}};
}

void ViewerMeshes::print_parts(const std::vector<MeshPart>& parts, JsonPrinter& json) {
  json.key("parts");
  json.begin_list();
  for (const MeshPart& part : parts) {
    json.begin_object();
    json.key("first");
    json.integer(part.first_index);
    if (part.color) {
      json.key("color");
      json.numbers(*part.color);
    }
    json.end();
  }
  json.end();
}

void ViewerMeshes::print(JsonPrinter& json) const {
  json.begin_list(JsonPrinter::Layout::block);
  for (const Shown& mesh : shown_) {
    json.begin_object();
    json.member("file", mesh.file);
    json.member("points", mesh.points);
    json.member("indices", mesh.indices);
    json.key("wide");
    json.boolean(mesh.is_wide);
    if (!mesh.texture_points.empty()) {
      json.key("texturePoints");
      json.text(mesh.texture_points);
    }
    if (has_colors(mesh.parts)) print_parts(mesh.parts, json);
    json.end();
  }
  json.end();
}

void ViewerMeshes::print_unseen(JsonPrinter& json) const {
  json.begin_list(JsonPrinter::Layout::block);
  for (const auto& [what, unseen] : unseen_) {
    json.begin_object();
    json.member("file", what.first);
    json.member("why", what.second);
    json.key("shapes");
    json.integer(static_cast<std::int64_t>(unseen.shapes));
    if (!unseen.package.empty()) json.member("package", unseen.package);
    json.end();
  }
  json.end();
}

}  // namespace smurf
