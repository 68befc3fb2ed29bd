// SPDX-License-Identifier: BSD-3-Clause
#include "flatten/dialect_parts.hpp"

namespace smurf::readings::spec_file {
namespace {

SceneReading read(const LinkedScene& scene) {
  SceneReading reading;
  reading.joint_poses = scene.joint_poses;
  reading.entities.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    reading.entities.push_back({instance.X_WE,
                                instance.placement.parent,
                                instance.placement.anchor,
                                instance.joint_pose,
                                {}});
  }
  return reading;
}

}  // namespace

extern constinit const Dialect spec{.name = "spec",
                                    .help = "as documented",
                                    .read = read,
                                    .pose_of = documented_pose,
                                    .is_moved_by_include = has_no_parent_link};

}  // namespace smurf::readings::spec_file
