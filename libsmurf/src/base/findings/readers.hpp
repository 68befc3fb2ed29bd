// SPDX-License-Identifier: BSD-3-Clause
// Declares every reader of readers.def, and facts that several rules share.
#pragma once

#include "base/findings/place_names.hpp"
#include "smurf/readers.hpp"

namespace smurf::readers {

#define SMURF_READER(name)                                                                         \
  namespace name##_file {                                                                          \
    extern const Reader name;                                                                      \
  }                                                                                                \
  using name##_file::name;
#include "base/findings/readers.def"
#undef SMURF_READER

}  // namespace smurf::readers

namespace smurf {

// Conditions of facts: at("limit/@upper"), when(kHex), since({3, 13}), or several of them, as in
// at("mass").when(kHex, kCarried).before({3, 13}).
template <std::same_as<Circumstance>... C>
consteval Where when(const C&... cases) {
  return Where{}.when(cases...);
}
consteval Where since(Version first) { return Where{}.since(first); }
consteval Where before(Version first) { return Where{}.before(first); }

/// urdfdom at an element of a link that it cannot read.
constexpr Fact urdfdom_drops_shapes(Where where = {},
                                    std::string_view evidence = "urdfdom link.cpp:415-486, run") {
  return {&readers::urdfdom, Effect::breaks,
          "reports an error and drops the visuals and collisions of the link that follow", evidence,
          where};
}

/// Readers at a mesh that they do not find or cannot read.
constexpr Fact ros_without_mesh(Where where = {}) {
  return {&readers::ros, Effect::loses, "RViz and MoveIt show the link without it",
          "urdfdom stores it unchecked", where};
}
constexpr Fact gazebo_without_mesh(Where where = {}) {
  return {&readers::gazebo, Effect::loses, "does not open the file; the link has no such shape",
          "sdformat parser_urdf.cc:2416-2431", where};
}
constexpr Fact newton_without_mesh(Where where = {}) {
  return {&readers::newton, Effect::loses, "warns, and builds the link without the shape", kRun,
          where};
}
constexpr Fact isaac_without_mesh(Where where = {}) {
  return {&readers::isaac, Effect::loses, "builds the link without the shape", kRun, where};
}
inline constexpr Fact kMarsWithoutCollision{
    &readers::mars, Effect::crashes, "ends with an exception on a missing mesh of a collision",
    "MARS gui_helper_functions.cpp:278-280, NodePhysics.cpp:626-634", at("collision")};
constexpr Fact mars_without_mesh(Where where = {}) {
  return {&readers::mars, Effect::loses, "shows the link without it", "MARS smurf.cpp:1080-1113",
          where};
}

}  // namespace smurf
