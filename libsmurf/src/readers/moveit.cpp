// SPDX-License-Identifier: BSD-3-Clause
// MoveIt 2: a robot with its SRDF and its parameter files.
#include "base/findings/readers.hpp"

namespace smurf::readers::moveit_file {
namespace {

// rosdistro: moveit2 of each distribution.
constexpr ReaderVersion kInHumble[] = {{&moveit, {2, 5}}};
constexpr ReaderVersion kInJazzy[] = {{&moveit, {2, 12}}};
constexpr ReaderVersion kInKilted[] = {{&moveit, {2, 14}}};
constexpr ReaderVersion kInRolling[] = {{&moveit, {2, 15}}};

constexpr Reader kHumble{.name = "moveit:humble",
                         .title = "MoveIt of Humble",
                         .basis = "moveit2 2.5, branch humble, read",
                         .like = &moveit,
                         .parts = kInHumble};
constexpr Reader kJazzy{.name = "moveit:jazzy",
                        .title = "MoveIt of Jazzy",
                        .basis = "moveit2 2.12, branch jazzy, read",
                        .like = &moveit,
                        .parts = kInJazzy};
constexpr Reader kKilted{.name = "moveit:kilted",
                         .title = "MoveIt of Kilted",
                         .basis = "moveit2 2.14, branch kilted, read",
                         .like = &moveit,
                         .parts = kInKilted};
constexpr Reader kRolling{.name = "moveit:rolling",
                          .title = "MoveIt of Rolling",
                          .basis = "moveit2 2.15, branch main (8fcb5d2), read",
                          .like = &moveit,
                          .parts = kInRolling};
constexpr const Reader* kReleases[] = {&kHumble, &kJazzy, &kKilted, &kRolling};

}  // namespace

extern constinit const Reader moveit{.name = "moveit",
                                     .title = "MoveIt",
                                     .basis = "MoveIt 2 8fcb5d2 (2026-08) read, srdfdom e23af6e "
                                              "(2024-10) run; as for urdfdom",
                                     .like = &urdfdom,
                                     .releases = kReleases};

}  // namespace smurf::readers::moveit_file
