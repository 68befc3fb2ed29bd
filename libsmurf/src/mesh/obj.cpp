// SPDX-License-Identifier: BSD-3-Clause
// Wavefront OBJ: positions, faces and the files it names; the rest is ignored, because each reader
// uses a different part of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "base/numbers/vectors.hpp"
#include "mesh/formats.hpp"
#include "mesh/mesh_reader.hpp"
#include "mesh/obj_materials.hpp"
#include "mesh/surface.hpp"
#include "mesh/words.hpp"

namespace smurf {
namespace {

class ObjReader {
 public:
  /// `triangles` receives the triangles with their texture coordinates and colours. It may be null,
  /// and so may `materials`.
  ObjReader(std::string_view text, MeshFacts& facts, SurfaceSum& surface,
            TriangleCollector* triangles, ObjMaterials* materials)
      : text_(text),
        words_(text),
        facts_(facts),
        surface_(surface),
        triangles_(triangles),
        materials_(materials) {}

  void read() {
    while (!facts_.defect && !words_.is_at_end()) {
      const std::string_view keyword = words_.next();
      line_ = words_.line();
      offset_ = words_.offset();
      std::string_view line = words_.rest_of_line();
      if (!line.ends_with('\\') || keyword.starts_with('#')) {
        statement(keyword, line);
        continue;
      }
      std::string joined;  // a line that ends in a backslash continues in the next one
      for (; line.ends_with('\\'); line = words_.next_line()) {
        joined += line.substr(0, line.size() - 1);
        joined += ' ';
      }
      statement(keyword, joined += line);
    }
    facts_.vertices = points_.size();
    facts_.box = box_.box();
    facts_.is_first_group_flat = group_.is_flat();
    if (facts_.defect) return;
    if (latest_ > points_.size()) {
      line_ = latest_line_;
      offset_ = latest_offset_;
      fail("a face uses vertex " + std::to_string(latest_) + ", but the file has only " +
           std::to_string(points_.size()));
    }
    check(last_texture_, texture_count_, "texture coordinates");
    check(last_normal_, normal_count_, "a normal");
    if (!facts_.defect && latest_ == 0) {
      surface_.write_to(facts_);
    }
  }

 private:
  void statement(std::string_view keyword, std::string_view line) {
    if (keyword == "v") {
      vertex(line);
    } else if (keyword == "f") {
      group_.has_content = true;
      facts_.has_more_groups = facts_.has_more_groups || group_.is_over;
      face(line);
    } else if (keyword == "o" || keyword == "g") {
      group_.is_over = group_.has_content;
    } else if (keyword == "vt") {
      ++texture_count_;
      if (wants_texture_points()) texture_vertex(line);
    } else if (keyword == "vn") {
      ++normal_count_;
    } else if (keyword == "mtllib" && !line.empty()) {
      facts_.dependencies.push_back(
          mesh_dependency(text_, line, MeshDependency::Kind::material_library, line_));
      if (materials_ != nullptr) materials_->read(line);
    } else if (keyword == "usemtl" && materials_ != nullptr) {
      triangles_->set_color(materials_->color_of(line));
    }
  }

  bool wants_texture_points() const {
    return triangles_ != nullptr && triangles_->wants_texture_points();
  }

  void vertex(std::string_view line) {
    Words numbers(line);
    Vector3 point;
    for (double& coordinate : point) {
      const std::string_view word = numbers.next();
      const auto number = parse_number(word);
      if (!number) {
        return fail(word.empty() ? "a vertex has fewer than three coordinates"
                                 : "the coordinate `" + std::string(word.substr(0, 20)) +
                                       "` is not a number");
      }
      coordinate = *number;
    }
    points_.push_back(
        {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])});
    box_.add(point);
  }

  void texture_vertex(std::string_view line) {
    Words numbers(line);
    const auto u = parse_number(numbers.next());
    const std::string_view second = numbers.next();
    const auto v = second.empty() ? std::optional(0.0) : parse_number(second);
    textures_.push_back(u && v ? texture_point(*u, *v) : kNoTexturePoint);
  }

  /// The texture coordinates of a corner of a face, such as "7/3" or "7/3/2".
  TexturePoint texture_of(std::string_view corner) const {
    const std::size_t slash = corner.find('/');
    if (slash == std::string_view::npos) return kNoTexturePoint;
    const std::string_view rest = corner.substr(slash + 1);
    const std::int64_t index = parse_integer(rest.substr(0, rest.find('/'))).value_or(0);
    const auto count = static_cast<std::int64_t>(textures_.size());
    if (index == 0 || index < -count || index > count) return kNoTexturePoint;
    return textures_[static_cast<std::size_t>(index < 0 ? count + index : index - 1)];
  }

  void face(std::string_view line) {
    Words words(line);
    std::optional<Vector3> first;
    std::optional<Vector3> previous;
    TextureCorners textures{};
    std::uint64_t corners = 0;
    bool is_known = true;
    while (!words.is_at_end()) {
      const std::string_view corner = words.next();
      const std::size_t slash = corner.find('/');
      const auto index = parse_integer(corner.substr(0, slash));
      if (!index || *index == 0) {
        return fail("the corner `" + std::string(corner.substr(0, 20)) +
                    "` of a face is not an index");
      }
      ++corners;
      if (slash != std::string_view::npos) note_attributes(corner.substr(slash + 1));
      const auto point = find(*index);
      if (facts_.defect) return;
      is_known = is_known && point.has_value();
      if (!is_known) continue;
      if (wants_texture_points()) textures[2] = texture_of(corner);
      if (first && previous && corners > 2) {
        surface_.add(*first, *previous, *point);
        if (!group_.is_over) group_.add(*first, *previous, *point);
        if (triangles_ != nullptr) triangles_->add(*first, *previous, *point, textures);
      }
      if (!first) {
        first = point;
        textures[0] = textures[2];
      }
      previous = point;
      textures[1] = textures[2];
    }
    if (corners < 3) return fail("a face has fewer than three corners");
    facts_.triangles += corners - 2;
  }

  /// The indices of the texture coordinates and of the normal: "3/2" of "7/3/2", or "/2" of "7//2".
  void note_attributes(std::string_view rest) {
    const std::size_t second = rest.find('/');
    note(rest.substr(0, second), texture_count_, last_texture_);
    if (second != std::string_view::npos)
      note(rest.substr(second + 1), normal_count_, last_normal_);
  }

  /// The first group, of which alone MuJoCo reads the faces.
  struct Group {
    bool has_content = false, is_over = false;
    std::optional<Vector3> origin;
    double volume = 0;  ///< sum of the volumes between the triangles and the origin
    double extent = 0;  ///< the greatest distance from the origin along an axis

    void add(const Vector3& a, const Vector3& b, const Vector3& c) {
      if (!origin) origin = a;
      const Vector3 p = difference(a, *origin);
      volume += std::fabs(dot(p, cross(difference(b, a), difference(c, a))));
      for (const Vector3& point : {p, difference(b, *origin), difference(c, *origin)}) {
        for (const double x : point) extent = std::max(extent, std::fabs(x));
      }
    }
    bool is_flat() const {
      constexpr double kFlat = 1e-9;  // of a cube with this extent; single precision has 1e-7
      return origin && volume <= kFlat * extent * extent * extent;
    }
  };

  struct LastIndex {
    std::int64_t index = 0;  ///< the greatest one
    std::uint32_t line = 0;
    std::uint64_t offset = 0;
  };
  void note(std::string_view word, std::int64_t count, LastIndex& last) {
    if (word.empty()) return;
    const std::int64_t index = parse_integer(word).value_or(0);
    if (index > last.index) last = {index, line_, offset_};
    if (index < -count || index == 0)
      last = {std::numeric_limits<std::int64_t>::max(), line_, offset_};
  }
  /// assimp and MuJoCo refuse the file. assimp ignores the indices if the file has none of these. A
  /// preview shows the triangles despite that.
  void check(const LastIndex& last, std::int64_t count, const std::string& what) {
    if (facts_.defect || triangles_ != nullptr || count == 0 || last.index <= count) return;
    line_ = last.line;
    offset_ = last.offset;
    fail("a corner of a face uses " + what + " that the file does not have");
  }

  /// None for a vertex that follows later or is missing.
  std::optional<Vector3> find(std::int64_t index) {
    const auto count = static_cast<std::int64_t>(points_.size());
    if (index < -count) {
      fail("a face uses vertex " + std::to_string(index) + ", but the file has only " +
           std::to_string(count) + " before it");
      return std::nullopt;
    }
    if (index > count) {
      if (static_cast<std::uint64_t>(index) > latest_) {
        latest_ = static_cast<std::uint64_t>(index);
        latest_line_ = line_;
        latest_offset_ = offset_;
      }
      return std::nullopt;
    }
    const auto& point = points_[static_cast<std::size_t>(index < 0 ? count + index : index - 1)];
    return Vector3{point[0], point[1], point[2]};
  }

  void fail(std::string what) { facts_.defect = {std::move(what), offset_, line_}; }

  std::string_view text_;
  Words words_;
  MeshFacts& facts_;
  std::uint32_t line_ = 1;
  std::uint64_t offset_ = 0;
  std::vector<std::array<float, 3>> points_;
  /// The greatest index of a vertex that a face names before the vertex.
  std::uint64_t latest_ = 0;
  std::uint32_t latest_line_ = 0;
  std::uint64_t latest_offset_ = 0;
  std::int64_t texture_count_ = 0, normal_count_ = 0;
  Group group_;
  LastIndex last_texture_, last_normal_;
  BoxSum box_;
  SurfaceSum& surface_;
  TriangleCollector* triangles_;
  ObjMaterials* materials_;
  std::vector<TexturePoint> textures_;  ///< if they were requested
};

}  // namespace

void read_obj(std::string_view text, MeshFacts& facts, SurfaceSum& surface) {
  ObjReader(text, facts, surface, nullptr, nullptr).read();
}

MeshFacts read_obj_triangles(std::string_view text, const MeshNeighbours& neighbours,
                             TriangleCollector& triangles) {
  MeshFacts facts;
  facts.format = MeshFormat::obj;
  const TriangleVisitor nothing_else;
  SurfaceSum surface(nothing_else);
  ObjMaterials materials(neighbours);
  ObjReader(text, facts, surface, &triangles, &materials).read();
  if (materials.has_textures()) triangles.note_textures();
  return facts;
}

bool has_faces_after_first_group(std::string_view text) {
  Words words(text);
  bool has_content = false;  // of the first group
  bool is_group_over = false;
  while (!words.is_at_end()) {
    const std::string_view keyword = words.next();
    words.rest_of_line();
    const bool is_face = keyword == "f";
    if (is_face && is_group_over) return true;
    if (is_face || keyword == "l" || keyword == "p") has_content = true;
    if (keyword == "o" || keyword == "g") is_group_over = has_content;
  }
  return false;
}

}  // namespace smurf
