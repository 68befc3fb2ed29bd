// SPDX-License-Identifier: BSD-3-Clause
// Binary STL: 80 bytes of header, a count, 50 bytes per triangle. ASCII STL: words.
#include <algorithm>
#include <cmath>

#include "base/files/path.hpp"
#include "base/numbers/little_endian.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "mesh/formats.hpp"
#include "mesh/surface.hpp"
#include "mesh/words.hpp"

namespace smurf {
namespace {

bool is_finite(const Vector3& point) {
  return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
}

/// "1.5e3", ".5", "nan", "-inf", "-nan(ind)".
bool begins_as_number(std::string_view word) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  if (word.starts_with('.')) word.remove_prefix(1);
  if (word.empty()) return false;
  const bool is_digit = word.front() >= '0' && word.front() <= '9';
  const std::string start = path::to_lower(word.substr(0, 3));
  return is_digit || start == "nan" || start == "inf";
}

class AsciiStlReader {
 public:
  AsciiStlReader(std::string_view text, MeshFacts& facts, SurfaceSum& surface)
      : text_(text), words_(text), facts_(facts), surface_(surface) {}

  void read() {
    check_start();
    while (!facts_.defect && !words_.is_at_end() && solid()) {
    }
    facts_.box = box_.box();
    if (!facts_.defect) surface_.write_to(facts_);
  }

 private:
  /// assimp, with which RViz and Gazebo read meshes, and three.js take the file for a binary STL
  /// otherwise (STLLoader.cpp, IsAsciiSTL()).
  void check_start() {
    const std::size_t begin = text_.find_first_not_of(" \t");
    if (begin != std::string_view::npos && text_.substr(begin).starts_with("solid")) return;
    facts_.defect = {"an ASCII STL has to begin with `solid`, in lower case", 0, 1};
  }

  bool solid() {
    if (!expect("solid")) return false;
    words_.rest_of_line();  // a name
    while (true) {
      const std::string_view word = words_.next();
      if (is(word, "endsolid")) {
        words_.rest_of_line();
        return true;
      }
      if (!is(word, "facet")) return unexpected(word, "facet");
      if (!facet()) return false;
    }
  }

  bool facet() {
    if (!expect("normal")) return false;
    // Normals are often zero or not a number, and readers compute their own. But assimp stops at
    // other words.
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = words_.next();
      if (!begins_as_number(word)) return unexpected(word, "a number");
    }
    if (!expect("outer") || !expect("loop")) return false;
    Vector3 corners[3];
    for (Vector3& corner : corners) {
      if (!vertex(corner)) return false;
    }
    if (!expect("endloop") || !expect("endfacet")) return false;
    ++facts_.triangles;
    surface_.add(corners[0], corners[1], corners[2]);
    return true;
  }

  bool vertex(Vector3& point) {
    if (!expect("vertex")) return false;
    for (double& coordinate : point) {
      const std::string_view word = words_.next();
      const auto number = parse_number(word);
      if (!number) return unexpected(word, "a number");
      coordinate = *number;
    }
    ++facts_.vertices;
    box_.add(point);
    return true;
  }

  static bool is(std::string_view word, std::string_view keyword) {
    return word == keyword || path::to_lower(word) == keyword;
  }

  bool expect(std::string_view keyword) {
    const std::string_view word = words_.next();
    return is(word, keyword) || unexpected(word, quoted(keyword));
  }

  /// Always false.
  bool unexpected(std::string_view word, const std::string& expected) {
    constexpr std::size_t kShown = 20;
    const std::string found =
        word.empty() ? "the file ends" : quoted(word.substr(0, kShown)) + " stands";
    facts_.defect = {found + " where " + expected + " is expected", words_.offset(), words_.line()};
    return false;
  }

  std::string_view text_;
  Words words_;
  MeshFacts& facts_;
  BoxSum box_;
  SurfaceSum& surface_;
};

}  // namespace

std::uint32_t stl_triangle_count(std::string_view bytes) {
  return read_uint32(bytes, kStlHeaderBytes - 4);
}

namespace {

constexpr std::size_t kNormalBytes = 12;
constexpr std::size_t kPointBytes = 12;

/// Adds the points without infinite coordinates.
void add_finite(const Vector3 (&corners)[3], BoxSum& box) {
  for (const Vector3& corner : corners) {
    if (is_finite(corner)) box.add(corner);
  }
}

MeshDefect not_a_number(const Vector3 (&corners)[3], std::size_t triangle) {
  std::size_t at = kStlHeaderBytes + triangle * kStlTriangleBytes + kNormalBytes;
  for (const Vector3& corner : corners) {
    if (!is_finite(corner)) break;
    at += kPointBytes;
  }
  return {"a vertex of triangle " + std::to_string(triangle + 1) + " is not a number", at, 0};
}

}  // namespace

void read_binary_stl(std::string_view bytes, MeshFacts& facts, SurfaceSum& surface) {
  facts.named_solid = bytes.starts_with("solid");
  if (bytes.size() < kStlHeaderBytes) {
    facts.defect = {"the file ends inside its header of " + std::to_string(kStlHeaderBytes) +
                        " bytes",
                    bytes.size(), 0};
    return;
  }
  const std::uint64_t announced = stl_triangle_count(bytes);
  const std::uint64_t needed = kStlHeaderBytes + announced * kStlTriangleBytes;
  if (needed != bytes.size()) {
    facts.defect = {"its header announces " + counted(announced, "triangle") + ", which take " +
                        std::to_string(needed) + " bytes, but the file has " +
                        std::to_string(bytes.size()),
                    kStlHeaderBytes - 4, 0};
  }
  facts.triangles =
      std::min<std::uint64_t>(announced, (bytes.size() - kStlHeaderBytes) / kStlTriangleBytes);
  facts.vertices = 3 * facts.triangles;
  BoxSum box;
  for (std::size_t i = 0; i < facts.triangles; ++i) {
    std::size_t at = kStlHeaderBytes + i * kStlTriangleBytes + kNormalBytes;
    Vector3 corners[3];
    double zero = 0;  // not a number, if a coordinate is infinite or not a number
    for (Vector3& corner : corners) {
      for (double& coordinate : corner) {
        coordinate = read_float(bytes, at);
        zero += 0 * coordinate;
        at += 4;
      }
    }
    if (zero == 0) {
      for (const Vector3& corner : corners) box.add(corner);
    } else {
      add_finite(corners, box);
      if (!facts.defect) facts.defect = not_a_number(corners, i);
    }
    surface.add(corners[0], corners[1], corners[2]);
  }
  facts.box = box.box();
  if (!facts.defect) surface.write_to(facts);
}

void read_ascii_stl(std::string_view text, MeshFacts& facts, SurfaceSum& surface) {
  AsciiStlReader(text, facts, surface).read();
}

}  // namespace smurf
