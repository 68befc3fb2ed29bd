// SPDX-License-Identifier: BSD-3-Clause
// What all readers of URDF have in common, unless their own table says otherwise.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr ReaderFact kFacts[] = {
    {"SML0001", refuses, "cannot read the file", "any reader"},
    {"SML0003", refuses, "refuses bytes that are no UTF-8, or shows them as something else",
     "urdf-loader 0.13.1, run", "/robot/"},
    {"SML0004", refuses, "refuses the file, or reads no further", "urdfdom 3.0.1, run"},
    {"SML1001", refuses, "refuses the file, or reads no further than the fault",
     "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14, run"},
    {"SML1006", changes, "reads the first root element only",
     "tinyxml2 FirstChildElement; urdfdom 3.0.1, run"},
    {"SML1007", refuses, "refuses the file", "urdfdom 3.0.1, MuJoCo 3.14, run"},
    {"SML1009", loses, "ignores the element, and what it would have become is missing",
     "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14, Bullet, run", "/xacro:"},
    {"SML1009", changes, "takes the text literally", "no URDF reader expands xacro", "/@filename/"},
    {"SML1009", changes, "takes the text literally", "no URDF reader expands xacro", "/@name/"},
    {"SML1010", refuses, "finds no document in the file", "urdfdom 3.0.1, run"},
    {"SML1101", refuses, "refuses a root other than `robot`", "urdfdom model.cpp:106, run"},
    {"SML1105", changes, "ignores the rotation, so the frame is not turned",
     "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14, Bullet, run", "/@quat_xyzw/"},
    {"SML1105", ignores, "ignores the attribute", "urdfdom 3.0.1, MuJoCo 3.14, run"},
    {"SML1106", loses, "ignores the element and all it holds",
     "urdfdom 3.0.1, sdformat 12.3, DART 6.12, MuJoCo 3.14, Bullet, run"},
    {"SML1107", changes, "ignores the attribute", "urdfdom 3.0.1, MuJoCo 3.14, run"},
    {"SML1108", loses, "ignores the element and all it holds", "urdfdom 3.0.1, MuJoCo 3.14, run"},
    {"SML1109", changes, "takes the first one", "urdfdom 3.0.1, Bullet, run"},
    {"SML1111", changes, "takes the first shape", "urdfdom 3.0.1, Bullet, run"},
    {"SML1114", refuses, "ignores the element, and then misses the link that joints name",
     "urdfdom 3.0.1, MuJoCo 3.14, run", "/Link/"},
    {"SML1114", refuses, "ignores the element, and then misses the link that joints name",
     "urdfdom 3.0.1, MuJoCo 3.14, run", "/LINK/"},
    {"SML1114", loses, "ignores the element and all it holds", "urdfdom 3.0.1, MuJoCo 3.14, run"},
    {"SML1115", refuses, "refuses a robot without links", "urdfdom 3.0.1, sdformat 12.3, run"},
    {"SML1201", refuses, "refuses the file", "urdfdom model.h:128; MuJoCo 3.14, Bullet, run"},
    {"SML1202", refuses, "refuses the file", "urdfdom model.h:128; MuJoCo 3.14, Bullet, run"},
    {"SML1203", refuses, "refuses the file", "urdfdom 3.0.1, MuJoCo 3.14, Bullet, run"},
    {"SML1204", refuses, "refuses the file: it looks for one root", "urdfdom model.h:176, run"},
    {"SML1205", refuses, "refuses the file: it finds no root", "urdfdom model.h:176, run"},
    {"SML1301", refuses, "refuses the file",
     "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14, Bullet, run"},
    {"SML1302", refuses, "refuses the file", "urdfdom 3.0.1, sdformat 12.3, Bullet, run"},
    {"SML1306", refuses, "does not find a link of that name, blank included", "urdfdom 3.0.1, run"},
    {"SML1401", refuses, "refuses the joint type, and the file", "urdfdom 3.0.1, MuJoCo 3.14, run"},
    {"SML1604", loses, "looks for the package in places of its own",
     "package folders depend on the machine", "#package"},
    {"SML7100", refuses, "reads no scenes", "only the MARS generations and Phobos do"},
};

}  // namespace

extern constinit const Reader urdf{
    .name = "urdf",
    .title = "every URDF reader",
    .basis = "what the readers below have in common, unless their own table says otherwise",
    .facts = kFacts,
    .is_target = false};

}  // namespace smurf::readers
