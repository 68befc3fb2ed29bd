// SPDX-License-Identifier: BSD-3-Clause
// DART, which reads URDF with urdfdom.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr ReaderFact kFacts[] = {
    {"SML1206", changes, "builds the link twice or does not come to an end", "DART 6.12.1, run"},
    {"SML1207", crashes, "does not come to an end", "DART 6.12.1, run"},
    {"SML1208", loses, "leaves the ring out", "DART 6.12.1, run"},
    {"SML1426", crashes, "ends the process by an assertion", "DART 6.12.1, run"},
    {"SML1508", changes, "warns and goes on with a mass matrix that is singular",
     "DART 6.12.1, run"},
    {"SML1509", changes, "warns and goes on", "DART 6.12.1, run"},
    {"SML1511", changes, "goes on with a mass matrix that is singular", "DART 6.12.1, run",
     "#moving"},
    {"SML1512", changes, "computes with it all the same", "DART 6.12.1, run"},
    {"SML1513", changes, "computes with it all the same", "DART 6.12.1, run"},
    {"SML1601", crashes, "ends the process by an assertion", "DART 6.12.1, run"},
    {"SML1604", refuses, "cannot load the shape, and refuses the file", "DART 6.12.1, run",
     "#mesh"},
    {"SML1627", crashes, "ends the process by an assertion", "DART 6.12.1, run"},
    {"SML1628", crashes, "ends the process by an assertion", "DART 6.12.1, run"},
    {"SML1911", refuses, "cannot load the shape, and refuses the file", "DART 6.12.1, run",
     "#bobj"},
    {"SML1911", refuses, "cannot load the shape, and refuses the file", "DART 6.12.1, run", "#glb"},
};

}  // namespace

extern constinit const Reader dart{.name = "dart",
                                   .title = "DART",
                                   .basis = "6.12.1 (Debian 12), executed",
                                   .like = &urdfdom,
                                   .facts = kFacts};

}  // namespace smurf::readers
