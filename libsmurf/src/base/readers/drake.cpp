// SPDX-License-Identifier: BSD-3-Clause
// Drake, by its own reader of URDF.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr std::string_view kWater = "puts a sphere of water with that mass in its place";

constexpr ReaderFact kFacts[] = {
    {"SML1009", refuses, "refuses what is left of the number", "Drake detail_tinyxml.h:60-73",
     "/@xyz/"},
    {"SML1009", changes, "reads 0", "Drake detail_tinyxml.h", "/@value/"},
    {"SML1102", refuses, "refuses a robot without name, unless the caller names it",
     "Drake detail_urdf_parser.cc:1452"},
    {"SML1110", refuses, "refuses the file", "Drake detail_urdf_geometry.cc"},
    {"SML1111", changes, "takes a box before a sphere before a cylinder before a mesh",
     "Drake detail_urdf_geometry.cc:318-346"},
    {"SML1113", refuses, "refuses the file", "Drake detail_urdf_geometry.cc", "/color/"},
    {"SML1113", takes, "needs no name of a material", "Drake detail_urdf_geometry.cc",
     "/material/"},
    {"SML1113", changes, "reads 0, which most inertias do not survive", "Drake detail_common.h:387",
     "/inertial/"},
    {"SML1113", ignores, "ignores safety controllers", "Drake detail_urdf_parser.cc",
     "/safety_controller/"},
    {"SML1113", refuses, "refuses the file", "Drake detail_urdf_parser.cc"},
    {"SML1115", takes, "takes a robot without links", "Drake detail_urdf_parser.cc"},
    {"SML1201", takes, "knows a link `world` that nobody declares",
     "Drake detail_urdf_parser.cc:518", "#world"},
    {"SML1204", takes, "takes several trees", "Drake detail_urdf_parser.cc"},
    {"SML1206", refuses, "refuses the model when it is finalised", "Drake issue 19034"},
    {"SML1208", refuses, "refuses the model when it is finalised", "Drake issue 19034"},
    {"SML1403", changes, "lets the joint move without limit", "Drake detail_urdf_parser.cc"},
    {"SML1404", changes, "reads infinity", "Drake detail_urdf_parser.cc"},
    {"SML1405", changes, "reads infinity", "Drake detail_urdf_parser.cc"},
    {"SML1406", changes, "reads infinity", "Drake detail_urdf_parser.cc"},
    {"SML1407", crashes, "ends the process", "Drake joint.h:159"},
    {"SML1409", changes, "enforces the limits", "Drake detail_urdf_parser.cc:628-643"},
    {"SML1414", loses, "leaves the actuator of the joint out",
     "Drake detail_urdf_parser.cc:930-1001"},
    {"SML1415", refuses, "refuses the file when a transmission drives the joint",
     "Drake detail_urdf_parser.cc:930-1001"},
    {"SML1416", changes, "keeps the joint from moving", "Drake detail_urdf_parser.cc"},
    {"SML1417", crashes, "ends the process", "Drake joint.h:160"},
    {"SML1421", refuses, "refuses an axis of length 0", "Drake detail_urdf_parser.cc"},
    {"SML1426", refuses, "refuses negative damping", "Drake revolute_joint.h:125"},
    {"SML1432", refuses, "refuses the file", "Drake detail_urdf_parser.cc:791-880"},
    {"SML1433", refuses, "refuses the file", "Drake detail_urdf_parser.cc:791-880"},
    {"SML1501", changes, "computes with a mass matrix that is singular", "Drake, read"},
    {"SML1508", refuses, "refuses a mass of 0 with an inertia", "Drake detail_common.cc:496"},
    {"SML1509", changes, kWater, "Drake detail_common.cc:446-515"},
    {"SML1511", changes, "computes with a mass matrix that is singular", "Drake, read", "#moving"},
    {"SML1512", changes, kWater, "Drake detail_common.cc:446-515"},
    {"SML1513", changes, kWater, "Drake detail_common.cc:446-515"},
    {"SML1601", refuses, "refuses a size that is not positive", "Drake shape_specification.h"},
    {"SML1602", takes, "knows the capsule", "Drake detail_urdf_geometry.cc:318-346", "/capsule/"},
    {"SML1602", refuses, "refuses the shape", "Drake detail_urdf_geometry.cc:318-346"},
    {"SML1604", refuses, "refuses the file", "Drake detail_path_utils.cc", "#mesh"},
    {"SML1604", refuses, "refuses the file", "Drake detail_path_utils.cc", "#texture"},
    {"SML1627", refuses, "refuses a scale below 1e-8", "Drake shape_specification.h"},
    {"SML1702", refuses, "refuses the file", "Drake detail_urdf_geometry.cc"},
    {"SML1704", refuses, "refuses the file, even when both are equal",
     "Drake detail_urdf_geometry.cc:54"},
    {"SML1802", takes, "skips blanks", "Drake detail_tinyxml.h:60-73"},
    {"SML1803", refuses, "refuses the number", "Drake detail_tinyxml.h:60-73"},
    {"SML1804", refuses, "refuses the number", "Drake detail_tinyxml.h:60-73"},
    {"SML1805", changes, "reads the digits before the comma", "Drake detail_tinyxml.h:60-73"},
    {"SML1808", takes, "skips blanks of every kind", "Drake detail_tinyxml.h:60-73"},
    {"SML1809", changes, "reads the digits in front", "Drake detail_tinyxml.h:60-73"},
    {"SML1810", changes, "reads 0", "Drake detail_tinyxml.h:60-73", "#underflow"},
    {"SML18", refuses, "refuses a vector with fewer numbers, reads 0 elsewhere",
     "Drake detail_tinyxml.h:60-73"},
    {"SML1911", takes, "reads it", "Drake make_convex_hull_mesh_impl.cc:279-291", "#obj"},
    {"SML1911", takes, "reads it", "Drake make_convex_hull_mesh_impl.cc:279-291", "#vtk"},
    {"SML1911", takes, "reads it", "Drake make_convex_hull_mesh_impl.cc:279-291", "#gltf"},
    {"SML1911", refuses, "throws when it needs the hull of the mesh",
     "Drake make_convex_hull_mesh_impl.cc:279-291", "/collision/"},
    {"SML1514", changes, kWater, "Drake rotational_inertia.cc:184-216", "#drake"},
    {"SML1915", changes, "couples the joints in some solvers only",
     "Drake detail_urdf_parser.cc:791-880"},
};

}  // namespace

extern constinit const Reader drake{.name = "drake",
                                    .title = "Drake",
                                    .basis = "be259df (2026-08), read",
                                    .like = &urdf,
                                    .facts = kFacts};

}  // namespace smurf::readers
