// SPDX-License-Identifier: BSD-3-Clause
// The resource manager of ros2_control, which reads the elements `ros2_control` of a URDF.
#include "base/findings/readers.hpp"

namespace smurf::readers::ros2_control_file {
namespace {

// rosdistro: ros2_control of each distribution.
constexpr ReaderVersion kInHumble[] = {{&ros2_control, {2, 54}}, {&urdfdom, {3, 0, 2}}};
constexpr ReaderVersion kInJazzy[] = {{&ros2_control, {4, 46}}, {&urdfdom, {4, 0, 2}}};
constexpr ReaderVersion kInKilted[] = {{&ros2_control, {5, 16}}, {&urdfdom, {4, 0, 2}}};
constexpr ReaderVersion kInRolling[] = {{&ros2_control, {6, 8}}, {&urdfdom, {6, 0}}};

constexpr Reader kHumble{
    .name = "ros2_control:humble",
    .title = "ros2_control of Humble",
    .basis = "ros2_control 2.54.0: its parser (branch humble, 0941f73) run, the rest read",
    .like = &ros2_control,
    .parts = kInHumble};
constexpr Reader kJazzy{
    .name = "ros2_control:jazzy",
    .title = "ros2_control of Jazzy",
    .basis = "ros2_control 4.46.0: its parser (branch jazzy, 9ffbf97) run, the rest read",
    .like = &ros2_control,
    .parts = kInJazzy};
constexpr Reader kKilted{
    .name = "ros2_control:kilted",
    .title = "ros2_control of Kilted",
    .basis = "ros2_control 5.16.0: its parser (branch kilted, cbe7d2c) run, the rest read",
    .like = &ros2_control,
    .parts = kInKilted};
constexpr Reader kRolling{.name = "ros2_control:rolling",
                          .title = "ros2_control of Rolling",
                          .basis = "ros2_control 6.8.0: its parser (53b9999) run, the rest read",
                          .like = &ros2_control,
                          .parts = kInRolling};
constexpr const Reader* kReleases[] = {&kHumble, &kJazzy, &kKilted, &kRolling};

}  // namespace

extern constinit const Reader ros2_control{
    .name = "ros2_control",
    .title = "ros2_control",
    .basis = "53b9999 (2026-08) and its branches humble, jazzy and kilted read; as for urdfdom",
    .like = &urdfdom,
    .releases = kReleases};

}  // namespace smurf::readers::ros2_control_file
