// SPDX-License-Identifier: BSD-3-Clause
// The closed surfaces of a mesh: welded, mirrored, and what is no closed surface.
#include "conversion/mesh_pieces.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace smurf;

namespace {

using Point = std::array<float, 3>;

/// A box as STL has it: each triangle has its own points.
void add_box(MeshTriangles& mesh, const Point& low, const Point& high, bool is_inside_out = false) {
  const auto corner = [&](unsigned i) {
    return Point{(i & 1U) != 0 ? high[0] : low[0], (i & 2U) != 0 ? high[1] : low[1],
                 (i & 4U) != 0 ? high[2] : low[2]};
  };
  constexpr unsigned kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& side : kSides) {
    for (const unsigned k : {0U, 1U, 2U, 0U, 2U, 3U}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.points.size()));
      mesh.points.push_back(corner(side[k]));
    }
    if (!is_inside_out) continue;
    for (std::size_t i = mesh.indices.size() - 6; i < mesh.indices.size(); i += 3)
      std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
}

}  // namespace

TEST_CASE("mesh pieces: two boxes are two pieces with their volumes, mirrored ones too") {
  MeshTriangles mesh;
  add_box(mesh, {0, 0, 0}, {1, 2, 3});
  add_box(mesh, {5, 0, 0}, {6, 1, 1});
  for (const Vector3& scale : {Vector3{1, 1, 1}, Vector3{-1, 1, 1}, Vector3{-1, -1, -1}}) {
    const CollisionBody body = body_of(mesh, scale);
    CHECK(body.points.size() == 16);
    CHECK(body.indices.size() == 72);
    const std::vector<BodyPiece> pieces = closed_pieces(body);
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].volume == doctest::Approx(6));
    CHECK(pieces[1].volume == doctest::Approx(1));
    CHECK(pieces[0].body.points.size() == 8);
  }
  CHECK(closed_pieces(body_of(mesh, {2, 3, 0.5}))[0].volume == doctest::Approx(18));
}

TEST_CASE("mesh pieces: an open surface, a hollow and a body that is inside out are none") {
  MeshTriangles hollow;
  add_box(hollow, {0, 0, 0}, {3, 3, 3});
  add_box(hollow, {1, 1, 1}, {2, 2, 2}, true);
  CHECK(closed_pieces(body_of(hollow, {1, 1, 1})).empty());
  MeshTriangles open;
  add_box(open, {0, 0, 0}, {1, 1, 1});
  open.indices.resize(open.indices.size() - 3);
  CHECK(closed_pieces(body_of(open, {1, 1, 1})).empty());
  MeshTriangles reversed;
  add_box(reversed, {0, 0, 0}, {1, 1, 1}, true);
  CHECK(closed_pieces(body_of(reversed, {1, 1, 1})).empty());
  MeshTriangles twice;
  add_box(twice, {0, 0, 0}, {1, 1, 1});
  add_box(twice, {0, 0, 0}, {1, 1, 1});
  CHECK(closed_pieces(body_of(twice, {1, 1, 1})).empty());
  CHECK(closed_pieces(body_of({}, {1, 1, 1})).empty());
}
