// SPDX-License-Identifier: BSD-3-Clause
// Wavefront OBJ: positions, faces and the files it names; the rest is ignored, because each reader
// uses a different part of it.
#include <array>
#include <functional>
#include <vector>

#include "base/numbers.hpp"
#include "mesh/formats.hpp"
#include "mesh/mesh_reader.hpp"
#include "mesh/surface.hpp"
#include "mesh/words.hpp"

namespace smurf {
namespace {

/// A line that was joined from several lines is not contained in the text.
MeshDependency named_in(std::string_view text, std::string_view name, MeshDependency::Kind kind,
                        std::uint32_t line) {
  const std::less<> is_before;
  const bool is_there = !is_before(name.data(), text.data()) &&
                        !is_before(text.data() + text.size(), name.data() + name.size());
  return {.filename = std::string(name),
          .kind = kind,
          .line = line,
          .offset = is_there ? static_cast<std::uint64_t>(name.data() - text.data()) : 0,
          .length = is_there ? name.size() : 0};
}

class ObjReader {
 public:
  /// `textured` receives the triangles with their texture coordinates; it may be null.
  ObjReader(std::string_view text, MeshFacts& facts, SurfaceSum& surface,
            TriangleCollector* textured)
      : text_(text), words_(text), facts_(facts), surface_(surface), textured_(textured) {}

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
    if (facts_.defect) return;
    if (latest_ > points_.size()) {
      line_ = latest_line_;
      offset_ = latest_offset_;
      fail("a face uses vertex " + std::to_string(latest_) + ", but the file has only " +
           std::to_string(points_.size()));
    } else if (latest_ == 0) {
      surface_.write_to(facts_);
    }
  }

 private:
  void statement(std::string_view keyword, std::string_view line) {
    if (keyword == "v") {
      vertex(line);
    } else if (keyword == "f") {
      face(line);
    } else if (keyword == "vt" && textured_ != nullptr) {
      texture_vertex(line);
    } else if (keyword == "mtllib" && !line.empty()) {
      facts_.dependencies.push_back(
          named_in(text_, line, MeshDependency::Kind::material_library, line_));
    }
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
      const auto index = parse_integer(corner.substr(0, corner.find('/')));
      if (!index || *index == 0) {
        return fail("the corner `" + std::string(corner.substr(0, 20)) +
                    "` of a face is not an index");
      }
      ++corners;
      const auto point = find(*index);
      if (facts_.defect) return;
      is_known = is_known && point.has_value();
      if (!is_known) continue;
      if (textured_ != nullptr) textures[2] = texture_of(corner);
      if (first && previous && corners > 2) {
        surface_.add(*first, *previous, *point);
        if (textured_ != nullptr) textured_->add(*first, *previous, *point, textures);
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
  BoxSum box_;
  SurfaceSum& surface_;
  TriangleCollector* textured_;
  std::vector<TexturePoint> textures_;  ///< if they were requested
};

}  // namespace

void read_obj(std::string_view text, MeshFacts& facts, SurfaceSum& surface) {
  ObjReader(text, facts, surface, nullptr).read();
}

MeshFacts read_textured_obj(std::string_view text, TriangleCollector& triangles) {
  MeshFacts facts;
  facts.format = MeshFormat::obj;
  const TriangleVisitor nothing_else;
  SurfaceSum surface(nothing_else);
  ObjReader(text, facts, surface, &triangles).read();
  return facts;
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
    textures.push_back(named_in(text, rest, MeshDependency::Kind::texture, line));
  }
  return textures;
}

}  // namespace smurf
