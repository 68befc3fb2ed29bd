// SPDX-License-Identifier: BSD-3-Clause
// Gazebo, which reads URDF with sdformat, which reads it with urdfdom.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr ReaderFact kFacts[] = {
    {"SML1113", breaks, "reports error E9, an axis of length 0", "sdformat 12.3, run", "/axis/"},
    {"SML1206", breaks, "reports a duplicate link", "sdformat 12.3, run"},
    {"SML1207", crashes, "crashes", "sdformat 12.3, run"},
    {"SML1208", loses, "leaves the ring out", "sdformat 12.3, run"},
    {"SML1303", breaks, "reports errors E2 and E24, the model cannot be used",
     "sdformat 12.3, run"},
    {"SML1407", changes, "swaps the two limits", "sdformat parser_urdf.cc:3127-3140, run"},
    {"SML1414", changes, "gives the joint no force", "sdformat 12.3, run"},
    {"SML1421", breaks, "reports error E9, an axis of length 0", "sdformat 12.3, run"},
    {"SML1501", loses, "drops the link with everything below it",
     "sdformat parser_urdf.cc:2669-2779, run"},
    {"SML1508", loses, "drops the link with everything below it",
     "sdformat parser_urdf.cc:2669-2779, run"},
    {"SML1509", breaks, "reports error E18, an invalid inertia", "sdformat 12.3, run"},
    {"SML1512", breaks, "reports error E18, an invalid inertia", "sdformat 12.3, run"},
    {"SML1513", breaks, "reports error E18, an invalid inertia", "sdformat 12.3, run"},
    {"SML1604", loses, "does not look for the file; the link has no such shape",
     "sdformat parser_urdf.cc:2416-2431", "#mesh"},
    {"SML1707", loses, "drops the material", "sdformat 12.3, run"},
    {"SML1911", loses, "has no loader for it", "sdformat 12.3 stores it unchecked", "#bobj"},
    {"SML1510", loses, "drops the link with everything below it", "sdformat 12.3, run (issue 199)",
     "#mass"},
    {"SML1514", breaks, "reports error E18, an invalid inertia", "gz-math MassMatrix3.hh, run",
     "#sdformat"},
    {"SML1915", loses, "leaves mimic out before sdformat 14: the joint moves on its own",
     "sdformat parser_urdf.cc:3152; 12.3, run"},
    {"SML1502", breaks, "drops every link, and refuses a model without links",
     "sdformat 12.3, run"},
    {"SML1916", breaks, "drops the root with everything below it: a model without links",
     "sdformat 12.3, run", "#root"},
};

}  // namespace

extern constinit const Reader gazebo{.name = "gazebo",
                                     .title = "Gazebo",
                                     .basis = "sdformat 12.3.0, executed; 17 (2ace536) read",
                                     .like = &urdfdom,
                                     .facts = kFacts};

}  // namespace smurf::readers
