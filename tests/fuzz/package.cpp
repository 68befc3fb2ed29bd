// SPDX-License-Identifier: BSD-3-Clause
// A ROS package: a robot with its parameter files, SRDF, launch files, package.xml and build files.
#include "fuzz/checked.hpp"
#include "fuzz/clock.hpp"

using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string robot = "p/robot.urdf.xacro";
  require_checked(unbundle(bytes, robot), robot);
  return 0;
}
