// SPDX-License-Identifier: BSD-3-Clause
#include "flatten/dialect_parts.hpp"

namespace smurf::readings {
namespace {

std::vector<EntityReading> read(const LinkedScene& scene) {
  std::vector<EntityReading> readings;
  readings.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    readings.push_back({instance.X_WE,
                        instance.placement.parent,
                        instance.placement.anchor,
                        instance.joint_positions,
                        {}});
  }
  return readings;
}

}  // namespace

extern constinit const Dialect spec{.name = "spec",
                                    .help = "as documented, which is what the author means",
                                    .read = read,
                                    .pose_of = documented_pose,
                                    .is_moved_by_include = has_no_parent_link};

}  // namespace smurf::readings
