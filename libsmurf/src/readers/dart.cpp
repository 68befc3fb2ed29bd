// SPDX-License-Identifier: BSD-3-Clause
// DART, which reads URDF with urdfdom.
#include "base/findings/readers.hpp"

namespace smurf::readers::dart_file {
namespace {

constexpr Fact kUnread[] = {
    {&dart, Effect::ignores, "does not open textures", kRun, at("texture/@filename")},
};

}  // namespace

extern constinit const Reader dart{.name = "dart",
                                   .title = "DART",
                                   .basis = "6.12.1 (Debian 12), executed",
                                   .like = &urdfdom,
                                   .version = "DART 6.12.1",
                                   .unread = kUnread};

}  // namespace smurf::readers::dart_file
