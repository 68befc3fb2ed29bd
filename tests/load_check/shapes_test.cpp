// SPDX-License-Identifier: BSD-3-Clause
// Shapes that are read from files: bodies that fall on meshes and heightfields.
#include <fstream>

#include "load_check/built.hpp"
#include "smurf-load-check/heightfield.hpp"
#include "support/temporary_folder.hpp"

using namespace smurf;
using namespace smurf::load_check;

namespace {

const std::string kBall = "<collision><geometry><sphere radius=\"0.1\"/></geometry></collision>";

const std::uint64_t kMostPixels = Limits{}.image_pixels;

std::string written(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// Two triangles: a square of 2 m at z = 0, around the origin.
const char* const kSquare =
    "solid square\n"
    "facet normal 0 0 1\nouter loop\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 1 1 0\n"
    "endloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex -1 -1 0\nvertex 1 1 0\nvertex -1 1 0\n"
    "endloop\nendfacet\nendsolid square\n";

std::string mesh(const std::string& path, const std::string& scale) {
  return "<collision><geometry><mesh filename=\"" + path + "\" scale=\"" + scale +
         "\"/></geometry></collision>";
}

}  // namespace

TEST_CASE("a mesh of what stands still is its triangles, a mesh of what moves is a box") {
  const test::TemporaryFolder folder;
  const std::string square = written(folder / "square.stl", kSquare);
  const std::string links = link("base", "0 0 0", 1, 0.01, mesh(square, "1 1 1")) +
                            link("arm", "0 0 0", 1, 0.01) + link("ball", "0 0 0", 1, 0.01, kBall);
  const std::string joints =
      joint("fixed", "1 0 0") +
      "<joint name=\"fall\" type=\"floating\"><parent link=\"arm\"/><child link=\"ball\"/>"
      "<origin xyz=\"0.3 0.2 0.15\"/></joint>";
  const Built still(links + joints, Base::Kind::world);
  REQUIRE(std::holds_alternative<TriangleShape>(still.plan.shapes[0].shape));
  WorldSetup setup;
  setup.contacts = true;
  World world(still.plan, setup);
  run(world, 1);
  const double height = world.body_pose(0).position[2];
  MESSAGE("a ball of 0.1 m rests " << height << " m above the triangles");
  CHECK(height == doctest::Approx(0.1).epsilon(1e-2));

  const Built moving(links + joints, Base::Kind::free);
  const ShapePlan& box = moving.plan.shapes[0];
  REQUIRE(std::holds_alternative<BoxShape>(box.shape));
  CHECK((std::get<BoxShape>(box.shape).size - Eigen::Vector3d(2, 2, 1e-4)).norm() < 1e-12);
  CHECK(box.is_stand_in);
}

TEST_CASE("a mesh is scaled as the URDF says") {
  const test::TemporaryFolder folder;
  const std::string square = written(folder / "scaled.stl", kSquare);
  const Built built(link("base", "0 0 0", 1, 0.01, mesh(square, "0.5 2 1")), Base::Kind::free);
  const Eigen::Vector3d size = std::get<BoxShape>(built.plan.shapes[0].shape).size;
  CHECK((size - Eigen::Vector3d(1, 4, 1e-4)).norm() < 1e-12);
}

TEST_CASE("a heightfield has its columns along x and its rows along y") {
  // Four terraces of 1 m x 1 m; a ball rests on each at its own height.
  HeightfieldShape field{2, 2, 21, 21, {}};
  for (std::size_t row = 0; row < field.rows; ++row) {
    for (std::size_t column = 0; column < field.columns; ++column) {
      field.heights.push_back(0.1F + (column > 10 ? 0.1F : 0.0F) + (row > 10 ? 0.2F : 0.0F));
    }
  }
  struct Place {
    double x, y, height;
  };
  for (const Place& place : {Place{-0.5, -0.5, 0.1}, Place{0.5, -0.5, 0.2}, Place{-0.5, 0.5, 0.3},
                             Place{0.5, 0.5, 0.4}}) {
    Built built(link("base", "0 0 0", 1, 0.01, kBall), Base::Kind::free, {},
                Pose{{place.x, place.y, place.height + 0.12}, {}});
    ShapePlan& ground = built.plan.shapes.emplace_back();
    ground.body = kEnvironment;
    ground.shape = field;
    WorldSetup setup;
    setup.contacts = true;
    World world(built.plan, setup);
    CHECK(world.overlaps().empty());
    run(world, 1);
    const double height = world.body_pose(0).position[2] - 0.1;
    MESSAGE("at (" << place.x << ", " << place.y << ") ground at " << height << " m");
    CHECK(height == doctest::Approx(place.height).epsilon(1e-2));
  }
}

TEST_CASE("heights are the grey values of a PNG, from the top row on") {
  const auto image =
      read_height_image(std::string(SMURF_FIXTURES) + "/scenes/terrain/heightmaps/terraces.png",
                        {DiskFiles()}, kMostPixels);
  REQUIRE(std::holds_alternative<HeightImage>(image));
  const HeightImage& terraces = std::get<HeightImage>(image);
  REQUIRE(terraces.columns == 33);
  REQUIRE(terraces.rows == 33);
  // With 16 bits, the middle values differ from those with 8 bits.
  CHECK(terraces.heights[0] == doctest::Approx(0.2).epsilon(1e-4));
  CHECK(terraces.heights[32] == doctest::Approx(0.4).epsilon(1e-4));
  CHECK(terraces.heights[32 * 33] == doctest::Approx(0.6).epsilon(1e-4));
  CHECK(terraces.heights[33 * 33 - 1] == doctest::Approx(0.8).epsilon(1e-4));
}

TEST_CASE("an image of a thousand million pixels is refused before it takes memory") {
  // Signature and header of a grey image of 60000 x 60000 pixels, with its check sum.
  const std::string header("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xea\x60\0\0\xea\x60\x08\0\0\0\0"
                           "\xa5\xb9\x2a\x9e"
                           "\0\0\0\0IDAT\x35\xaf\x06\x1e",
                           45);
  const test::TemporaryFolder folder;
  const std::string huge = written(folder / "huge.png", header);
  const auto image = read_height_image(huge, {DiskFiles()}, kMostPixels);
  REQUIRE(std::holds_alternative<std::string>(image));
  CHECK(
      std::get<std::string>(image) ==
      "it has 3600000000 pixels, more than 16000000; raise the limit with `--limit image-pixels=N`");
}

TEST_CASE("an image that is none, or is cut off, has a reason") {
  const test::TemporaryFolder folder;
  const std::string text = written(folder / "text.png", "these are no heights");
  std::ifstream whole(std::string(SMURF_FIXTURES) + "/scenes/terrain/heightmaps/terraces.png",
                      std::ios::binary);
  std::string bytes(60, '\0');
  whole.read(bytes.data(), 60);
  const std::string part = written(folder / "part.png", bytes);
  for (const std::string& path : {text, part, std::string("/no/such.png")}) {
    const auto image = read_height_image(path, {DiskFiles()}, kMostPixels);
    REQUIRE(std::holds_alternative<std::string>(image));
    CHECK(!std::get<std::string>(image).empty());
  }
}
