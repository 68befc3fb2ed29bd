// SPDX-License-Identifier: BSD-3-Clause
// The programs of ROS that take a URDF: urdfdom, RViz, MoveIt, KDL.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr ReaderFact kFacts[] = {
    {"SML1309", changes, "tf2 takes `/` for the separator of frames", "tf2 frame names"},
    {"SML1416", changes, "MoveIt takes 0 for no limit", "MoveIt robot_model.cpp:874"},
    {"SML1417", changes, "MoveIt takes the absolute value", "MoveIt robot_model.cpp:874"},
    {"SML1422", changes, "MoveIt does not normalise the axis of a prismatic joint",
     "MoveIt robot_model.cpp"},
    {"SML1429", changes, "MoveIt reads the absent limits as 0 and freezes the joint",
     "MoveIt robot_model.cpp:849-860"},
    {"SML1433", loses, "MoveIt drops every mimic of the robot", "MoveIt robot_model.cpp:426"},
    {"SML1604", loses, "RViz and MoveIt show the link without it", "urdfdom stores it unchecked",
     "#mesh"},
    {"SML1911", loses, "has no loader for it: RViz and MoveIt show the link without it",
     "assimp 5.2", "#bobj"},
    {"SML1917", loses, "KDL warns, and computes without the mass of the root", "kdl_parser"},
};

}  // namespace

extern constinit const Reader ros{.name = "ros",
                                  .title = "ROS",
                                  .basis = "urdfdom 3.0.1, executed; MoveIt 1 (fdb79ac) read",
                                  .like = &urdfdom,
                                  .facts = kFacts};

}  // namespace smurf::readers
