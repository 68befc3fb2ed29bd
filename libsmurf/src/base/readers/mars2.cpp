// SPDX-License-Identifier: BSD-3-Clause
// MARS 2 (mars-robot-simulation) with its envire model loader and its scene loader.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr ReaderFact kFacts[] = {
    {"SML0010", crashes, "ends with an uncaught exception", "configmaps, run"},
    {"SML0011", changes, "takes the first value", "configmaps ConfigMap.cpp:53, run"},
    {"SML0012", crashes, "ends with an uncaught exception", "configmaps, run"},
    {"SML0013", loses, "reads the first document only", "configmaps, run"},
    {"SML4101", loses, "skips this and all following motors", "envire_smurf_loader Model.cpp"},
    {"SML5009", changes, "goes by the extension", "MarsSceneLoader.cpp:206-226"},
    {"SML5013", changes, "has one frame for the two", "MarsSceneLoader.cpp"},
    {"SML5016", changes, "reads degrees", "MarsSceneLoader.cpp"},
    {"SML5017", changes, "reads w, x, y, z", "MarsSceneLoader.cpp"},
    {"SML5029", loses, "reads `entities` only", "MarsSceneLoader.cpp"},
    {"SML5102", changes, "fixes the entity to a frame of that name", "MarsSceneLoader.cpp:361-397"},
    {"SML5105", breaks, "reports an error and leaves all joints at zero",
     "MarsSceneLoader.cpp:338-346"},
    {"SML7001", crashes, "dereferences a null pointer", "envire_smurf_loader Model.cpp:636-641"},
    {"SML7003", crashes, "ends with an uncaught exception", "envire_smurf_loader Model.cpp:216-230",
     "/link/"},
    {"SML7003", crashes, "ends with an uncaught exception", "envire_smurf_loader Model.cpp:443-505",
     "/sensors/"},
    {"SML7003", loses, "finds no collision for it", "envire_smurf_loader Model.cpp", "/collision/"},
    {"SML7004", crashes, "ends with an uncaught exception", "envire_smurf_loader Model.cpp:443-456",
     "#type"},
    {"SML7004", changes, "computes with whatever is in memory", "envire_types motors"},
    {"SML7005", takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#PID"},
    {"SML7005", takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#DC"},
    {"SML7005", takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#DirectEffort"},
    {"SML7005", takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#FeedForwardEffort"},
    {"SML7005", takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#direct_effort"},
    {"SML7005", takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#ff_torque"},
    {"SML7005", takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#position"},
    {"SML7005", loses, "skips this and all following motors",
     "envire_smurf_loader Model.cpp:455-478"},
    {"SML2017", loses, "does not read `URIs`", "envire_smurf_loader Model.cpp"},
    {"SML7100", refuses, "reads .smurfs only", "MarsSceneLoader.cpp:76", "#smurfa"},
    {"SML7100", takes, "reads scenes", "MarsSceneLoader.cpp:76"},
    {"SML7101", changes, "fixes the entity to the world", "MarsSceneLoader.cpp:361-397"},
    {"SML7102", changes, "places the entity in the world frame", "MarsSceneLoader.cpp"},
    {"SML7104", crashes, "ends with an uncaught exception", "MarsSceneLoader.cpp"},
    {"SML7105", loses, "takes only its .yml entities, and ignores the pose",
     "MarsSceneLoader.cpp:209, 249-298"},
    {"SML7106", refuses, "reports an error and stops loading the scene",
     "MarsSceneLoader.cpp:206-226"},
    {"SML7108", loses, "reads `entities` only", "MarsSceneLoader.cpp"},
};

}  // namespace

extern constinit const Reader mars2{
    .name = "mars2",
    .title = "MARS 2",
    .basis = "envire_smurf_loader dbfa612, mars_scene_loader 685f76d, read; configmaps, executed",
    .like = &urdfdom,
    .facts = kFacts};

}  // namespace smurf::readers
