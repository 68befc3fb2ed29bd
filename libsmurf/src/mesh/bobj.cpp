// SPDX-License-Identifier: BSD-3-Clause
// The .bobj of MARS (gui_helper_functions.cpp:390-599): records of a tag and numbers, without any
// header or count. MARS does not check indices: it reads out of bounds where this reader reports a
// fault.
#include <array>
#include <cmath>

#include "base/numbers/little_endian.hpp"
#include "mesh/formats.hpp"
#include "mesh/surface.hpp"

namespace smurf {
namespace {

enum Tag : std::int32_t { vertex = 1, texture = 2, normal = 3, face = 4, color = 5 };

/// Bytes of a record after its tag; 0 for an unknown tag.
std::size_t payload(std::int32_t tag) {
  switch (tag) {
  case vertex:
  case normal: return 12;
  case texture: return 8;
  case face: return 36;
  case color: return 16;
  default: return 0;
  }
}

class BobjReader {
 public:
  BobjReader(std::string_view bytes, MeshFacts& facts, SurfaceSum& surface)
      : bytes_(bytes), facts_(facts), surface_(surface) {}

  void read() {
    while (at_ < bytes_.size() && record()) {
    }
    facts_.vertices = points_.size();
    facts_.box = box_.box();
    if (facts_.defect) return;
    surface_.write_to(facts_);
    // MARS reads chunks of this size and loses the records that the last full chunk leaves over.
    constexpr std::size_t kChunk = 256;
    if (bytes_.size() % kChunk == 0) {
      facts_.defect = {"its size is a multiple of 256 bytes, of which MARS loses the last triangle",
                       bytes_.size(), 0};
    }
  }

 private:
  bool record() {
    if (at_ + 4 > bytes_.size()) return fail("the file ends inside a record");
    const std::int32_t tag = read_int32(bytes_, at_);
    const std::size_t size = payload(tag);
    if (size == 0) return fail("there is no record of kind " + std::to_string(tag));
    if (at_ + 4 + size > bytes_.size()) return fail("the file ends inside a record");
    const bool is_sound = tag == vertex ? add_vertex() : tag != face || add_face();
    if (tag == normal) ++normals_;
    if (tag == texture) ++textures_;
    at_ += 4 + size;
    return is_sound;
  }

  bool add_vertex() {
    Vector3 point;
    for (std::size_t i = 0; i < 3; ++i) {
      point[i] = read_float(bytes_, at_ + 4 + 4 * i);
      if (!std::isfinite(point[i])) return fail("a coordinate of a vertex is not a number");
    }
    points_.push_back(
        {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])});
    box_.add(point);
    return true;
  }

  bool add_face() {
    Vector3 corners[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t corner = at_ + 4 + 12 * i;
      const std::int32_t v = read_int32(bytes_, corner);
      const std::int32_t vt = read_int32(bytes_, corner + 4);
      const std::int32_t vn = read_int32(bytes_, corner + 8);
      if (!check("vertex", v, points_.size()) || !check("normal", vn, normals_)) return false;
      if (vt != 0 && !check("texture coordinate", vt, textures_)) return false;
      const auto& point = points_[static_cast<std::size_t>(v) - 1];
      corners[i] = {point[0], point[1], point[2]};
    }
    ++facts_.triangles;
    surface_.add(corners[0], corners[1], corners[2]);
    return true;
  }

  bool check(const std::string& what, std::int32_t index, std::size_t count) {
    if (index >= 1 && static_cast<std::size_t>(index) <= count) return true;
    return fail("a triangle names the " + what + " " + std::to_string(index) + ", but " +
                std::to_string(count) + " precede it");
  }

  /// Always false.
  bool fail(std::string what) {
    facts_.defect = {std::move(what), at_, 0};
    return false;
  }

  std::string_view bytes_;
  MeshFacts& facts_;
  std::size_t at_ = 0;
  std::vector<std::array<float, 3>> points_;
  std::size_t normals_ = 0;
  std::size_t textures_ = 0;
  BoxSum box_;
  SurfaceSum& surface_;
};

}  // namespace

void read_bobj(std::string_view bytes, MeshFacts& facts, SurfaceSum& surface) {
  BobjReader(bytes, facts, surface).read();
}

}  // namespace smurf
