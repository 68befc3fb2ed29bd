// SPDX-License-Identifier: BSD-3-Clause
// The shapes of a scene as triangles in the world frame, z up, in metres: for programs that do not
// support robots or scenes.
#include <array>
#include <map>
#include <span>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "base/text/misread.hpp"
#include "base/text/utf8.hpp"
#include "write/losses/scene_losses.hpp"
#include "write/pages/preview_meshes.hpp"
#include "write/parts/annotated_colors.hpp"
#include "write/parts/placed_shapes.hpp"
#include "write/parts/unit_meshes.hpp"
#include "write/text/long_text.hpp"

namespace smurf::scene_obj_file {
namespace {

/// The lengths of the shortest line of a point and of a third of a triangle.
constexpr PreviewMeshes::Cost kCost{8, 3};

constexpr int kDigits = 8;  // about the largest float

/// A name ends at a space, and a backslash at the end of a line continues the line.
std::string name_in_obj(std::string_view text) {
  std::string name;
  for (std::size_t at = 0; at < text.size();) {
    const utf8::CodePoint point = utf8::decode(text.substr(at));
    const bool ends_name = point.value == ' ' || point.value == '\\' ||
                           utf8::is_control(point.value) || is_misread(text, at, point.value);
    if (ends_name) {
      name += '_';
    } else {
      utf8::append(name, point.value);
    }
    at += point.size;
  }
  return name;
}

class ObjWriter {
 public:
  explicit ObjWriter(const SceneExport& scene)
      : scene_(scene), losses_(scene, SceneColumn::gltf, "OBJ"), files_(scene, kCost) {}

  std::string run() {
    out_ = "# metres, z up; points may have colours\n";
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (scene_.flat.instances[i].X_WE) add_instance(i);
    }
    return std::move(out_);
  }

 private:
  void add_instance(std::size_t index) {
    const FlatInstance& instance = scene_.flat.instances[index];
    for (const ShownLink& link : shown_links(scene_, index, frames_, colors_)) {
      if (link.shapes.empty()) continue;
      const std::string name = link.name.empty() ? instance.path : instance.path + "::" + link.name;
      out_ += "o " + name_in_obj(name) + '\n';
      for (const LinkShape& shape : link.shapes) add_shape(*instance.X_WE * link.X_EL, shape);
    }
  }

  void add_shape(const Pose& X_WL, const LinkShape& shape) {
    if (out_.size() > scene_.most_bytes) return;
    const Pose X_WS = X_WL * shape.X_LS;
    const auto* mesh = std::get_if<FlatMesh>(&shape.geometry);
    if (mesh == nullptr) {
      const std::vector<PlacedSolid> solids = solids_of(shape.geometry);
      if (solids.empty()) losses_.unseen_shape(shape.span, shape.geometry, {});
      for (const PlacedSolid& solid : solids) {
        const TriangleMesh unit = unit_mesh(solid.solid);
        add_points(unit.points, X_WS * solid.X_GS, solid.scale, shape.color);
        add_triangles(unit.indices, unit.points.size(), solid.scale);
      }
      return;
    }
    const MeshTriangles& read = triangles_of(files_.first_name(mesh->file), shape.span);
    if (!read.reason.empty()) {
      return losses_.unseen_shape(shape.span, shape.geometry, read.reason);
    }
    for (std::size_t i = 0; i < read.parts.size(); ++i) {
      const bool is_last = i + 1 == read.parts.size();
      const std::size_t first = read.parts[i].first_point;
      const std::size_t end = is_last ? read.points.size() : read.parts[i + 1].first_point;
      add_points(std::span(read.points).subspan(first, end - first), X_WS, mesh->scale,
                 shape.color ? shape.color : read.parts[i].color);
    }
    add_triangles(read.indices, read.points.size(), mesh->scale);
  }

  const MeshTriangles& triangles_of(const std::string& file, Span place) {
    const auto [known, is_new] = triangles_.try_emplace(file);
    if (is_new) known->second = files_.read(file, place);
    return known->second;
  }

  void add_points(std::span<const std::array<float, 3>> points, const Pose& X_WS,
                  const Vector3& scale, const std::optional<Rgba>& color) {
    std::string end = "\n";
    if (color) {
      end = " " + format_number((*color)[0]) + " " + format_number((*color)[1]) + " " +
            format_number((*color)[2]) + "\n";
    }
    for (const auto& [x, y, z] : points) {
      const Pose X_SP{{x * scale[0], y * scale[1], z * scale[2]}, {}};
      const Vector3 p_WP = (X_WS * X_SP).position;
      make_room(out_);
      out_ += 'v';
      for (const double component : p_WP) out_ += ' ' + format_rounded(component, kDigits);
      out_ += end;
    }
  }

  /// Writes triangles of the last points. Reverses them if the scale mirrors the points.
  template <class Index>
  void add_triangles(const std::vector<Index>& indices, std::size_t points, const Vector3& scale) {
    const bool is_mirrored = scale[0] * scale[1] * scale[2] < 0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      make_room(out_);
      out_ += 'f';
      for (const std::size_t corner :
           {i, is_mirrored ? i + 2 : i + 1, is_mirrored ? i + 1 : i + 2}) {
        out_ += ' ' + std::to_string(first_ + indices[corner]);
      }
      out_ += '\n';
    }
    first_ += points;
  }

  const SceneExport& scene_;
  SceneLosses losses_;
  PreviewMeshes files_;
  LinkFrames frames_;
  AnnotatedColors colors_;
  std::map<std::string, MeshTriangles> triangles_;  ///< by file
  std::size_t first_ = 1;                           ///< number of the next point
  std::string out_;
};

}  // namespace

extern constinit const SceneFormat scene_obj{
    .name = "obj",
    .help = "all shapes as one Wavefront OBJ, in the world frame",
    .write = [](const SceneExport& scene) { return ObjWriter(scene).run(); },
    .repeats_models = true};

}  // namespace smurf::scene_obj_file
