// SPDX-License-Identifier: BSD-3-Clause
// MARS with envire (envire4mars), the generation between MARS 1 and MARS 2.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr ReaderFact kFacts[] = {
    {"SML0010", crashes, "ends with an uncaught exception", "configmaps, run"},
    {"SML0011", changes, "takes the first value", "configmaps ConfigMap.cpp:53, run"},
    {"SML0012", crashes, "ends with an uncaught exception", "configmaps, run"},
    {"SML0013", loses, "reads the first document only", "configmaps, run"},
    {"SML4101", changes, "takes it for a position controller", "MARS MotorData.cpp:126-135"},
    {"SML7001", crashes, "dereferences a null pointer", "rock-cpp/smurf Robot.cpp:233-241"},
    {"SML7002", changes, "reads 0: the shape collides with nothing", "rock-cpp/smurf Robot.cpp:73"},
    {"SML7003", loses, "finds no collision for it", "rock-cpp/smurf Robot.cpp", "/collision/"},
    {"SML7005", takes, "knows it", "MARS MotorData.cpp:126-135", "#PID"},
    {"SML7005", takes, "knows it", "MARS MotorData.cpp:126-135", "#DC"},
    {"SML7005", takes, "knows it", "MARS MotorData.cpp:126-135", "#generic_"},
    {"SML7005", takes, "knows it", "MARS MotorData.cpp:126-135", "#direct_"},
    {"SML7005", changes, "takes it for a position controller", "MARS MotorData.cpp:126-135"},
    {"SML2017", loses, "does not read the file", "rock-cpp/smurf Robot.cpp"},
};

}  // namespace

extern constinit const Reader envire{
    .name = "envire",
    .title = "MARS with envire",
    .basis = "rock-cpp/smurf 3e3b886, envire_smurf_loader 91afc56, read; configmaps, executed",
    .like = &urdfdom,
    .facts = kFacts};

}  // namespace smurf::readers
