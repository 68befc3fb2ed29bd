// SPDX-License-Identifier: BSD-3-Clause
#include "write/viewer_meshes.hpp"

#include <limits>

#include "base/bits.hpp"
#include "write/base64.hpp"

namespace smurf {

/// The bytes of a point (three floats) and of an index (at least two bytes), in base64.
constexpr PreviewMeshes::Cost kCost{16, 2};

ViewerMeshes::ViewerMeshes(const SceneExport& scene, bool has_copies)
    : files_(scene, kCost), has_copies_(has_copies) {}

const ViewerMeshes::Known& ViewerMeshes::find(const std::string& file, Span place) {
  const std::string& first = files_.first_name(file);
  const auto [known, is_new] = known_.try_emplace(first);
  if (is_new) known->second = read(first, place);
  return known->second;
}

ViewerMeshes::Known ViewerMeshes::read(const std::string& file, Span place) {
  const MeshTriangles mesh = files_.read(file, place);
  if (!mesh.reason.empty()) return {std::nullopt, mesh.reason};
  Shown shown{.file = file,
              .points = {},
              .indices = {},
              .parts = mesh.parts,
              .is_wide = mesh.points.size() > std::numeric_limits<std::uint16_t>::max()};
  std::string bytes;
  for (const std::array<float, 3>& point : mesh.points) {
    for (const float coordinate : point) append_bytes(bytes, bit_cast<std::uint32_t>(coordinate));
  }
  shown.points = base64(bytes);
  bytes.clear();
  for (const std::uint32_t index : mesh.indices) {
    if (shown.is_wide) {
      append_bytes(bytes, index);
    } else {
      append_bytes(bytes, static_cast<std::uint16_t>(index));
    }
  }
  shown.indices = base64(bytes);
  for (std::size_t i = 0; has_copies_ && i < shown_.size(); ++i) {
    if (shown_[i].points == shown.points && shown_[i].indices == shown.indices) return {i, {}};
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
    if (has_colors(mesh.parts)) print_parts(mesh.parts, json);
    json.end();
  }
  json.end();
}

void ViewerMeshes::print_unseen(JsonPrinter& json) const {
  json.begin_list(JsonPrinter::Layout::block);
  for (const auto& [what, shapes] : unseen_) {
    json.begin_object();
    json.member("file", what.first);
    json.member("why", what.second);
    json.key("shapes");
    json.integer(static_cast<std::int64_t>(shapes));
    json.end();
  }
  json.end();
}

}  // namespace smurf
