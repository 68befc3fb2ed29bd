// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/collada_geometry.hpp"

#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "mesh/words.hpp"

namespace smurf::collada {
namespace {

using xml::View;

bool has_triangles(std::string_view element) {
  constexpr std::string_view kNames[] = {"triangles", "polylist", "polygons", "tristrips",
                                         "trifans"};
  return std::find(std::begin(kNames), std::end(kNames), element) != std::end(kNames);
}

/// Every second triangle of a strip has the opposite order of corners.
void add_strip(const std::vector<std::uint32_t>& strip, std::vector<std::uint32_t>& corners) {
  for (std::size_t i = 2; i < strip.size(); ++i) {
    const bool is_turned = i % 2 == 1;
    corners.insert(corners.end(),
                   {strip[i - (is_turned ? 1 : 2)], strip[i - (is_turned ? 2 : 1)], strip[i]});
  }
}

bool is_between_words(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// The words of a list of indices: as Words and parse_integer(), faster for most indices.
class IndexWords {
 public:
  explicit IndexWords(std::string_view text) : text_(text) {}

  bool is_at_end() {
    while (at_ < text_.size() && is_between_words(text_[at_])) ++at_;
    return at_ == text_.size();
  }

  /// Reads the next word. Negative if it is no index.
  std::int64_t next() {
    constexpr std::size_t kShort = 9;
    begin_ = at_;
    std::int64_t index = 0;
    for (; at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9'; ++at_) {
      if (at_ - begin_ == kShort) break;
      index = 10 * index + (text_[at_] - '0');
    }
    const bool is_plain = at_ > begin_ && (at_ == text_.size() || is_between_words(text_[at_]));
    if (is_plain) return index;
    while (at_ < text_.size() && !is_between_words(text_[at_])) ++at_;
    return parse_integer(word()).value_or(-1);
  }
  std::string_view word() const { return text_.substr(begin_, at_ - begin_); }

 private:
  std::string_view text_;
  std::size_t at_ = 0, begin_ = 0;
};

void add_fan(const std::vector<std::uint32_t>& fan, std::vector<std::uint32_t>& corners) {
  for (std::size_t i = 2; i < fan.size(); ++i) {
    corners.insert(corners.end(), {fan[0], fan[i - 1], fan[i]});
  }
}

}  // namespace

Geometry GeometryReader::read(View element) {
  Geometry geometry;
  const View mesh = element.child("mesh");
  if (!mesh || problem_) return geometry;
  bool is_read = false;
  for (const View child : mesh) {
    if (!has_triangles(child.name())) continue;
    if (!is_read && !read_points(mesh, geometry)) return geometry;
    is_read = true;
    read_primitives(child, geometry);
    if (problem_) return geometry;
  }
  return geometry;
}

std::vector<double> GeometryReader::numbers_of(View array) {
  if (known_ == nullptr) return numbers(array.text());
  const auto found = known_->find(array.id());
  return found == known_->end() ? numbers(array.text()) : std::move(found->second);
}

bool GeometryReader::read_points(View mesh, Geometry& geometry) {
  const View source = positions_of(mesh);
  const View array = source ? source.child("float_array") : View();
  if (!array) return fail(mesh, "the points of the mesh are missing");
  const View technique = source.child("technique_common");
  if (const View accessor = technique ? technique.child("accessor") : View()) {
    const std::string_view named = value(accessor, "source");
    if (named.empty() || id_in(named) != value(array, "id")) {
      return fail(accessor, "the accessor of the points names no list of numbers of its source");
    }
  }
  const std::vector<double> all = numbers_of(array);
  if (!is_finite(all)) return fail(array, "some coordinates of the vertices are not numbers");
  const Layout layout = layout_of(source);
  const std::size_t count = layout.points(all.size());
  geometry.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* point = &all[layout.offset + i * layout.stride];
    geometry.points.push_back(
        {point[layout.axes[0]], point[layout.axes[1]], point[layout.axes[2]]});
  }
  points_ = count;
  if (wants_textures_) {
    sources_.emplace(mesh);
    textured_ = {};
  }
  return true;
}

void GeometryReader::read_primitives(View element, Geometry& geometry) {
  Geometry::Part part{value(element, "material"), {}};
  if (add(element, geometry, part.corners) && !part.corners.empty()) {
    geometry.parts.push_back(std::move(part));
  }
}

std::optional<GeometryReader::Indices> GeometryReader::indices_of(View primitives) {
  Indices indices;
  bool has_points = false;
  for (const View input : primitives) {
    if (input.name() != "input") continue;
    constexpr std::int64_t kMost = 1000;
    const auto offset = parse_integer(value(input, "offset"));
    if (!offset || *offset < 0 || *offset > kMost) {
      fail(input, "the offset of an input is not a small number");
      return std::nullopt;
    }
    const auto place = static_cast<std::size_t>(*offset);
    indices.stride = std::max(indices.stride, place + 1);
    const std::string_view semantic = value(input, "semantic");
    if (wants_textures_ && semantic == "TEXCOORD" && indices.textures == nullptr) {
      indices.texture_offset = place;
      indices.textures = sources_->of(input);
    }
    if (semantic != "VERTEX" || has_points) continue;
    const View vertices = primitives.parent().child("vertices");
    if (!vertices || id_in(value(input, "source")) != value(vertices, "id")) {
      fail(input, "the input VERTEX names no vertices of its mesh");
      return std::nullopt;
    }
    indices.offset = place;
    has_points = true;
  }
  if (has_points) return indices;
  fail(primitives, "no input of a primitive has the semantic VERTEX");
  return std::nullopt;
}

bool GeometryReader::read_corners(View list, const Indices& indices, Geometry& geometry) {
  corners_.clear();
  textures_.clear();
  IndexWords words(list.text());
  std::size_t place = 0;
  while (!words.is_at_end()) {
    const std::int64_t index = words.next();
    const std::size_t own = place;
    if (++place == indices.stride) place = 0;
    if (indices.textures != nullptr && own == indices.texture_offset) textures_.push_back(index);
    if (own != indices.offset) continue;
    if (index < 0 || static_cast<std::uint64_t>(index) >= points_) {
      return fail(list, "the index " + quoted(words.word()) + " names none of " +
                            std::to_string(points_) + " points");
    }
    corners_.push_back(static_cast<std::uint32_t>(index));
  }
  if (place != 0) return fail(list, "the indices end inside a corner");
  if (indices.textures != nullptr) {
    textured_.join(textures_, *indices.textures, corners_, geometry.points,
                   geometry.texture_points);
  }
  return true;
}

bool GeometryReader::add(View primitives, Geometry& geometry, std::vector<std::uint32_t>& corners) {
  const std::string_view name = primitives.name();
  if (name == "polylist") return add_polygons(primitives, geometry, corners);
  std::optional<Indices> indices;
  for (const View list : primitives) {
    // A polygon with holes.
    if (list.name() == "ph")
      return fail(list, "has polygons with holes, which are not read", false);
    if (list.name() != "p") continue;
    if (!indices) indices = indices_of(primitives);
    if (!indices || !read_corners(list, *indices, geometry)) return false;
    if (name == "tristrips") {
      add_strip(corners_, corners);
    } else if (name == "trifans") {
      add_fan(corners_, corners);
    } else if (name == "polygons") {
      splitter_.split(corners_, geometry.points, corners);
    } else if (corners_.size() % 3 == 0) {
      corners.insert(corners.end(), corners_.begin(), corners_.end());
    } else {
      return fail(list, "the indices end inside a triangle");
    }
  }
  return true;
}

bool GeometryReader::add_polygons(View primitives, Geometry& geometry,
                                  std::vector<std::uint32_t>& corners) {
  const View counts = primitives.child("vcount");
  const View list = primitives.child("p");
  if (!counts || !list) return true;  // none
  const std::optional<Indices> indices = indices_of(primitives);
  if (!indices || !read_corners(list, *indices, geometry)) return false;
  std::size_t begin = 0;
  Words words(counts.text());
  while (!words.is_at_end()) {
    const auto count = parse_integer(words.next());
    const std::size_t left = corners_.size() - begin;
    if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > left) {
      return fail(counts, "the polygons have more corners than there are indices");
    }
    const auto size = static_cast<std::size_t>(*count);
    splitter_.split({corners_.data() + begin, size}, geometry.points, corners);
    begin += size;
  }
  return begin == corners_.size() ||
         fail(counts, "there are more indices than corners of the polygons");
}

bool GeometryReader::fail(View element, std::string what, bool is_defect) {
  if (!problem_) problem_ = Problem{element, std::move(what), is_defect};
  return false;
}

}  // namespace smurf::collada
