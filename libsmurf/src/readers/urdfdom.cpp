// SPDX-License-Identifier: BSD-3-Clause
// urdfdom: the URDF parser of ROS, Gazebo, DART and both versions of MARS.
#include "readers/circumstances.hpp"

namespace smurf::readers::urdfdom_file {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML18",
     {&urdfdom, refuses, "refuses the number, and with it the file", "urdfdom utils.h:73-88, run",
      at("joint")}},
    {"SML18", urdfdom_drops_shapes(at("link"))},
    {"SML18",
     {&urdfdom, loses, "drops the material with a message", "urdfdom link.cpp:86-94, run",
      at("material")}},
};

constexpr Fact kUnread[] = {
    {&urdfdom, ignores, "does not read the axis of such a joint", kRun,
     at("joint/axis").when(kInFixed)},
    {&urdfdom, ignores, "does not read the axis of such a joint", kRun,
     at("joint/axis").when(kInFloating)},
};

}  // namespace

extern constinit const Reader urdfdom{.name = "urdfdom",
                                      .title = "urdfdom",
                                      .basis = "3.0.1 (Debian 12), 4.0.1 and 6.0.0, executed",
                                      .like = &urdf,
                                      .version = "urdfdom 3.0.1",
                                      .families = kFamilies,
                                      .is_target = false,
                                      .unread = kUnread,
                                      .number = {3, 0, 1}};

}  // namespace smurf::readers::urdfdom_file
