// SPDX-License-Identifier: BSD-3-Clause
// The values that readers know for some keys. Plug-ins add others. Sources: MARS
// MotorData.cpp:126-135, SensorManager.cpp, EntityFactoryManager.cpp; MARS 2 envire_smurf_loader
// Model.cpp; Phobos 2 representation.py.
#pragma once

#include <span>
#include <string_view>

namespace smurf {

inline constexpr std::string_view kMotorTypes[] = {"PID",
                                                   "DC",
                                                   "generic_bldc",
                                                   "generic_dc",
                                                   "direct_torque",
                                                   "direct_effort",
                                                   "1",
                                                   "2",
                                                   "7",
                                                   "DirectEffort",
                                                   "FeedForwardEffort",
                                                   "ff_torque",  // MARS 2
                                                   "position",
                                                   "velocity",
                                                   "force"};  // Phobos 2

/// The sensor types of MARS.
inline constexpr std::string_view kSensorTypes[] = {"JointPosition",
                                                    "JointVelocity",
                                                    "JointLoad",
                                                    "JointTorque",
                                                    "JointAVGTorque",
                                                    "NodePosition",
                                                    "NodeRotation",
                                                    "NodeVelocity",
                                                    "NodeAngularVelocity",
                                                    "NodeIMU",
                                                    "NodeCOM",
                                                    "NodeContact",
                                                    "NodeContactForce",
                                                    "MotorCurrent",
                                                    "Joint6DOF",
                                                    "CameraSensor",
                                                    "RaySensor",
                                                    "RotatingRaySensor",
                                                    "MultiLevelLaserRangeFinder",
                                                    "ScanningSonar",
                                                    "HapticField"};

inline constexpr std::string_view kEntityTypes[] = {"smurf",  "urdf",      "sdf",     "mjcf",
                                                    "smurfs", "smurfa",    "scn",     "scene",
                                                    "yml",    "primitive", "particle"};

inline constexpr std::string_view kParents[] = {"world"};  // beside names
inline constexpr std::string_view kAnchors[] = {"none", "world", "parent"};

/// The known values of a key of a section; empty for most keys.
constexpr std::span<const std::string_view> known_words(std::string_view entry,
                                                        std::string_view key) {
  if (entry == "motor" && key == "type") return kMotorTypes;
  if (entry == "sensor" && key == "type") return kSensorTypes;
  if (entry != "entities" && entry != "entity") return {};
  if (key == "type") return kEntityTypes;
  if (key == "parent") return kParents;
  if (key == "anchor") return kAnchors;
  return {};
}

}  // namespace smurf
