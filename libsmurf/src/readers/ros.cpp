// SPDX-License-Identifier: BSD-3-Clause
// The programs of ROS that load a URDF: urdfdom, RViz, MoveIt, KDL.
#include "base/findings/readers.hpp"

namespace smurf::readers::ros_file {
namespace {

// rosdistro, pull requests 32566, 45868 and 50827. The number of ROS is the year of the release.
constexpr ReaderVersion kInHumble[] = {{&urdfdom, {3, 0, 2}}, {&ros, {2022}}};
constexpr ReaderVersion kInJazzy[] = {{&urdfdom, {4, 0, 2}}, {&ros, {2024}}};
constexpr ReaderVersion kInRolling[] = {{&urdfdom, {6, 0}}, {&ros, {2026}}};

constexpr Reader kHumble{.name = "ros:humble",
                         .title = "ROS Humble",
                         .basis = "urdfdom 3.0.2; 3.0.1 executed",
                         .like = &ros,
                         .parts = kInHumble};
constexpr Reader kJazzy{.name = "ros:jazzy",
                        .title = "ROS Jazzy",
                        .basis = "urdfdom 4.0.2; 4.0.1 executed",
                        .like = &ros,
                        .parts = kInJazzy};
constexpr Reader kRolling{.name = "ros:rolling",
                          .title = "ROS Rolling",
                          .basis = "urdfdom 6.0.0, executed",
                          .like = &ros,
                          .parts = kInRolling};
constexpr const Reader* kReleases[] = {&kHumble, &kJazzy, &kRolling};

}  // namespace

extern constinit const Reader ros{.name = "ros",
                                  .title = "ROS",
                                  .basis = "as for urdfdom; MoveIt 1 (fdb79ac) read",
                                  .like = &urdfdom,
                                  .releases = kReleases};

}  // namespace smurf::readers::ros_file
