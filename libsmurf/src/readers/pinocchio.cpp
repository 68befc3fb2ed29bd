// SPDX-License-Identifier: BSD-3-Clause
// Pinocchio, which reads URDF with urdfdom, and looks for the shapes of its links.
#include "readers/circumstances.hpp"

namespace smurf::readers::pinocchio_file {
namespace {

using enum Effect;

constexpr Fact kUnread[] = {
    {&pinocchio, ignores, "reads `mimic` only if it is called with `mimic=True`", kRun,
     at("joint/mimic/@joint")},
};

constexpr ReaderVersion kParts[] = {{&urdfdom, {6, 0}}};

}  // namespace

extern constinit const Reader pinocchio{
    .name = "pinocchio",
    .title = "Pinocchio",
    .basis = "4.1.0 with urdfdom 6.0.0 (wheels `pin`, `cmeel-urdfdom`), executed: the model and "
             "both kinds of shapes",
    .like = &urdfdom,
    .version = "Pinocchio 4.1.0",
    .unread = kUnread,
    .parts = kParts};

}  // namespace smurf::readers::pinocchio_file
