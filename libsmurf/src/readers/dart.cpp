// SPDX-License-Identifier: BSD-3-Clause
// DART, which reads URDF with urdfdom.
#include <string_view>

#include "base/findings/readers.hpp"

namespace smurf::readers::dart_file {
namespace {

constexpr Fact kUnread[] = {
    {&dart, Effect::ignores, "does not open textures", kRun, at("texture/@filename")},
};

constexpr std::string_view kBasis =
    "6.12.1 (Debian 12), executed, with the folders of the packages given";
constexpr ReaderVersion kIn612[] = {{&dart, {6, 12, 1}}, {&urdfdom, {3, 0, 1}}};
constexpr Reader kDart612{
    .name = "dart:6.12", .title = "DART 6.12", .basis = kBasis, .like = &dart, .parts = kIn612};
constexpr ReaderVersion kIn620[] = {{&dart, {6, 20}}, {&urdfdom, {4, 0}}};
constexpr Reader kDart620{
    .name = "dart:6.20",
    .title = "DART 6.20",
    .basis = "6.20.0 (wheel `dartpy`, with urdfdom 4.0, without assertions), executed",
    .like = &dart,
    .parts = kIn620};
constexpr const Reader* kReleases[] = {&kDart612, &kDart620};

}  // namespace

extern constinit const Reader dart{.name = "dart",
                                   .title = "DART",
                                   .basis = kBasis,
                                   .like = &urdfdom,
                                   .version = "DART 6.12.1",
                                   .unread = kUnread,
                                   .number = {6, 12, 1},
                                   .releases = kReleases};

}  // namespace smurf::readers::dart_file
