// SPDX-License-Identifier: BSD-3-Clause
// urdfdom: what ROS, Gazebo, DART and both MARS parse URDF with.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr std::string_view kRestOfLink =
    "reports an error and drops the visuals and collisions of the link that follow";

constexpr ReaderFact kFacts[] = {
    {"SML1009", loses, "ignores the element, and what it would have become is missing",
     "urdfdom 3.0.1, run", "/xacro:"},
    {"SML1009", changes, "takes the text literally", "urdfdom 3.0.1, run", "/@filename/"},
    {"SML1009", changes, "takes the text literally", "urdfdom 3.0.1, run", "/@name/"},
    {"SML1009", refuses, "refuses the number, and with it the file", "urdfdom 3.0.1, run",
     "/joint/"},
    {"SML1009", breaks, kRestOfLink, "urdfdom link.cpp:415-486, run", "/link/"},
    {"SML1012", crashes, "passes the text to printf as a format, which may end the process",
     "urdfdom 3.0.1 link.cpp:93 and others, run; fixed in 5.1 (pull request 243)"},
    {"SML1102", refuses, "refuses a robot without name", "urdfdom model.cpp:115, run"},
    {"SML1104", refuses, "refuses every version but 1.0", "urdfdom model.cpp:126-137, run"},
    {"SML1110", breaks, kRestOfLink, "urdfdom link.cpp:415-486, run"},
    {"SML1113", changes, "reads the axis 0 0 0", "urdfdom 3.0.1 joint.cpp, run", "/axis/"},
    {"SML1113", refuses, "refuses the file", "urdfdom 3.0.1, run", "/joint/"},
    {"SML1113", breaks, kRestOfLink, "urdfdom link.cpp:415-486, run", "/link/"},
    {"SML1113", loses, "drops the material", "urdfdom model.cpp:146, run", "/material/"},
    {"SML1206", changes, "does not notice, and keeps the joint that is last in the alphabet",
     "urdfdom 3.0.1, run"},
    {"SML1207", changes, "accepts it; programs that walk the tree do not come to an end",
     "urdfdom issue 154; check_urdf 3.0.1, run"},
    {"SML1208", loses, "accepts it; the ring is reached from no root", "urdfdom 3.0.1, run"},
    {"SML1305", refuses, "reports two roots and refuses the file", "urdfdom 3.0.1, run"},
    {"SML1403", refuses, "refuses the file", "urdfdom 3.0.1, run"},
    {"SML1404", refuses, "refuses the file", "urdfdom 3.0.1, run"},
    {"SML1405", refuses, "refuses the file", "urdfdom 3.0.1, run"},
    {"SML1406", changes, "reads an absent limit as 0", "urdfdom 3.0.1, run"},
    {"SML1407", changes, "keeps limits that no position satisfies", "urdfdom 3.0.1, run"},
    {"SML1409", ignores, "keeps the limits, and its users ignore them", "urdfdom 3.0.1, run"},
    {"SML1421", changes, "accepts it: the joint has no direction", "urdfdom 3.0.1, run"},
    {"SML1425", refuses, "refuses the file", "urdfdom 3.0.1, run"},
    {"SML1432", changes, "does not look for the joint; it is left free", "urdfdom 3.0.1, run"},
    {"SML1602", breaks, kRestOfLink, "urdfdom 3.0.1 link.cpp:224, run"},
    {"SML1702", changes, "leaves the visual without colour and prints a message",
     "urdfdom 3.0.1, run"},
    {"SML1704", refuses, "refuses the file", "urdfdom model.cpp:147, run"},
    {"SML1707", loses, "drops the material with a message", "urdfdom link.cpp:86-94, run"},
    {"SML1807", changes, "reads a colour of three numbers as black", "urdfdom color.h:88, run",
     "/@rgba/"},
    {"SML1810", changes, "reads 0", "urdfdom 3.0.1, run", "#underflow"},
    {"SML18", refuses, "refuses the number, and with it the file", "urdfdom utils.h:73-88, run",
     "/joint/"},
    {"SML18", breaks, kRestOfLink, "urdfdom link.cpp:415-486, run", "/link/"},
    {"SML18", loses, "drops the material with a message", "urdfdom link.cpp:86-94, run",
     "/material/"},
};

}  // namespace

extern constinit const Reader urdfdom{.name = "urdfdom",
                                      .title = "urdfdom",
                                      .basis = "3.0.1 (Debian 12), executed; 4.0 and 5.0 compared",
                                      .like = &urdf,
                                      .facts = kFacts,
                                      .is_target = false};

}  // namespace smurf::readers
